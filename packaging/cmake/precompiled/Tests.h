// What tests share.
#pragma once

#include "packaging/cmake/precompiled/Standard.h"

#include <gtest/gtest.h>
