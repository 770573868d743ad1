// What the whole model answers to forces at rest, or nearly: residual
// flexibility.
//
//   u = T (T' (K + shift M) T)^-1 T' f
//
// The shift keeps a structure that nothing holds from moving away.
#pragma once

#include "updating/structure/solve/factor.hpp"
#include "updating/structure/solve/free_motions.hpp"
#include "updating/structure/solve/system.hpp"

#include <Eigen/Core>

#include <memory>
#include <mutex>
#include <vector>

namespace tapfit::updating {

/// The matrix is factored when an answer is first asked for, on whatever
/// thread that is: a base that was kept needs it only for effects.
class ResidualFlexibility {
 public:
  /// @param system, motions must outlive this
  /// @param shift [rad^2/s^2]
  ResidualFlexibility(const structure::System& system,
                      const structure::FreeMotions& motions,
                      double shift)
      : system_(system), motions_(motions), shift_(shift) {}

  /// @param forces f, n x columns
  [[nodiscard]] Eigen::MatrixXd to(const Eigen::MatrixXd& forces) const;

  /// To unit forces at degrees of freedom, those that move, and the dynamic
  /// corrections of these: (A^-1 M)^k A^-1 f for k below `orders`. Each further
  /// one makes the error of an FRF at the top of the band some hundred times
  /// smaller.
  [[nodiscard]] Eigen::MatrixXd to_points(const std::vector<int>& points,
                                          std::size_t orders = 2) const;

 private:
  // T' (K + shift M) T.
  [[nodiscard]] const structure::Factor& factor() const;

  const structure::System& system_;
  const structure::FreeMotions& motions_;
  double shift_;
  mutable std::once_flag once_;
  mutable std::unique_ptr<structure::Factor> factor_;
};

}  // namespace tapfit::updating
