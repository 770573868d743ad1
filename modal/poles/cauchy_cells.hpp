// Where a pole's sums over lines have been expanded before. Poles that are
// refined move little from one step to the next, most of them hardly at all, so
// that the few terms of a power series around a place nearby stand for sums
// over all lines.
//
// Places are the middles of squares of a grid that is finer near the lines,
// where the sums change faster: what is found does not depend on what was asked
// for before, or on which thread asked.
#pragma once

#include <Eigen/Core>

#include <complex>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <tuple>

namespace tapfit::modal {

/// A square of the grid. From its middle to its corners is a tenth of the way
/// to the nearest line, or less.
struct CauchyCell {
  int exponent = 0;  ///< of its width, a power of two
  double x = 0.0;    ///< its middle, in widths
  double y = 0.0;

  /// The square that a lies in, a on none of the lines.
  ///
  /// @param last lines are 0 .. last
  [[nodiscard]] static CauchyCell of(const std::complex<double>& a,
                                     double last);
  [[nodiscard]] std::complex<double> centre() const;
  [[nodiscard]] double radius() const;  ///< from the middle to a corner

  [[nodiscard]] auto operator<=>(const CauchyCell&) const = default;
};

/// What was worked out for squares; forgets all where they become many.
class CauchyCells {
 public:
  using Powers = std::shared_ptr<const Eigen::MatrixXcd>;

  /// @param expanded called where the square is not known yet
  [[nodiscard]] Powers find(const CauchyCell& cell,
                            const std::function<Eigen::MatrixXcd()>& expanded);

 private:
  std::mutex guard_;
  std::map<CauchyCell, Powers> known_;
};

}  // namespace tapfit::modal
