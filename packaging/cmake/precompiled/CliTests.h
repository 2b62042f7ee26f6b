// What tests of the command line share.
#pragma once

#include "packaging/cmake/precompiled/Tests.h"

#include <nlohmann/json.hpp>
