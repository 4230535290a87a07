#pragma once
/// Joining corners at one place, for formats that list each face with corners of its own.

#include "core/model/position_table.h"
