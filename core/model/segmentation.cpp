#include "core/model/segmentation.h"

namespace chartflood {

const char* stopReasonId(StopReason reason) {
  switch (reason) {
  case StopReason::NotStopped:
    return "not-stopped";
  case StopReason::Converged:
    return "converged";
  case StopReason::Cycle:
    return "cycle";
  case StopReason::MaxIterations:
    return "max-iterations";
  case StopReason::NoImprovement:
    return "no-improvement";
  case StopReason::Balanced:
    return "balanced";
  case StopReason::Cancelled:
    return "cancelled";
  }
  return "";
}

}  // namespace chartflood
