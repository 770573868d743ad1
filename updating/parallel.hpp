// Independent pieces of work on all cores: acquisition/parallel.hpp.
#pragma once

#include "acquisition/parallel.hpp"

namespace tapfit::updating {

using tapfit::for_each_parallel;

}  // namespace tapfit::updating
