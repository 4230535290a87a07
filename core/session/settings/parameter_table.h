#pragma once
/// The rows of the parameter table by subject, in the order of the table; parameters.h has the
/// whole.

#include <vector>

#include "core/session/settings/parameters.h"

namespace chartflood {

std::vector<ParameterInfo> modelRows();
std::vector<ParameterInfo> chartRows();
std::vector<ParameterInfo> balanceRows();
std::vector<ParameterInfo> borderRows();
std::vector<ParameterInfo> cuttingRows();
std::vector<ParameterInfo> unwrapRows();
std::vector<ParameterInfo> stoppingRows();
std::vector<ParameterInfo> methodRows();

}  // namespace chartflood
