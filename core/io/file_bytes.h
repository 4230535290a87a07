#pragma once
/// The content of a file, see core/base.

#include "core/base/file_bytes.h"
