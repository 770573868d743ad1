#define TAPFIT_INSTANCE template
#include "acquisition/eigen_instances/decompositions.hpp"
