// What a base is to be good for.
#pragma once

#include "updating/cache/matrix_cache.hpp"

#include <optional>
#include <vector>

namespace tapfit::updating {

/// What a base is asked for.
enum class BaseUse {
  Fit,   ///< the FRFs between the points given; see lean_span.hpp
  Scan,  ///< any grid may be asked about
};

struct BaseOptions {
  double high_hz = 100.0;  ///< top of the band
  double reach = 4.0;      ///< modes up to reach * high_hz
  bool split = true;       ///< every element once more
  /// Bases are compared with those of the deck on another mesh, by all grids.
  bool on_two_meshes = false;
  /// Degrees of freedom that are measured or hit (6 grid_index + component - 1)
  std::vector<int> points = {};
  /// Of these, one end of every pair; empty: all of them.
  std::vector<int> driven = {};
  /// Where what is solved for is kept; empty: nowhere.
  std::optional<MatrixCache> cache = {};
};

}  // namespace tapfit::updating
