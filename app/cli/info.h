#pragma once
/// What --info and the --list options print.

#include <string>

#include "core/session/session.h"

namespace chartflood {

/// What the file holds, its Gauss area and each repair. \pre mesh and Gauss area are there
std::string infoText(const Results& results);

std::string sampleList();
std::string colorMapList();
std::string bindingList();

}  // namespace chartflood
