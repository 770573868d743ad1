// Bases that were made already: the same effects are asked for in one look
// after another.
#pragma once

#include "updating/reduction/base_matrices.hpp"
#include "updating/reduction/base_options.hpp"
#include "updating/reduction/stiffness_change.hpp"

#include <Eigen/Core>

#include <deque>
#include <memory>
#include <mutex>
#include <vector>

namespace tapfit::updating {

/// What a base is asked for, see BaseBuilder::build().
struct BaseRequest {
  std::vector<int> points;
  std::vector<StiffnessChange> changes;
  BaseUse use = BaseUse::Fit;

  bool operator==(const BaseRequest&) const = default;
};

/// The last bases made, as many as 64 MB hold. Any thread may ask.
class MadeBases {
 public:
  /// @return null where it was not made or is kept no longer
  [[nodiscard]] std::shared_ptr<const ReducedBase> find(
      const BaseRequest& request) const;

  void keep(BaseRequest request, std::shared_ptr<const ReducedBase> base);

 private:
  struct Made {
    BaseRequest request;
    std::shared_ptr<const ReducedBase> base;
    Eigen::Index numbers = 0;
  };

  static constexpr Eigen::Index most_numbers = 8'000'000;  // 64 MB

  mutable std::mutex mutex_;
  std::deque<Made> made_;  // oldest first
  Eigen::Index numbers_ = 0;
};

}  // namespace tapfit::updating
