#pragma once

// Declares the instances of Eigen's templates that most files would otherwise
// compile for themselves; half of the time of a build from nothing went there.
// Part of the precompiled header, so nothing has to include it; a file without
// it compiles its own and links all the same.
#include "acquisition/eigen_instances/decompositions.hpp"
#include "acquisition/eigen_instances/products.hpp"
