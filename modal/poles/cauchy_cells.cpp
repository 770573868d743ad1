#include "modal/poles/cauchy_cells.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace tapfit::modal {
namespace {

constexpr int finer = 3;                 // widths are an eighth of the distance
constexpr std::size_t most_known = 500;  // ten or so for each mode

}  // namespace

CauchyCell CauchyCell::of(const std::complex<double>& a, double last) {
  const double beside = a.real() - std::clamp(a.real(), 0.0, last);
  const double distance = std::hypot(beside, a.imag());
  CauchyCell cell;
  cell.exponent = std::ilogb(distance) - finer;
  cell.x = std::round(std::ldexp(a.real(), -cell.exponent));
  cell.y = std::round(std::ldexp(a.imag(), -cell.exponent));
  return cell;
}

std::complex<double> CauchyCell::centre() const {
  return {std::ldexp(x, exponent), std::ldexp(y, exponent)};
}

double CauchyCell::radius() const {
  return std::ldexp(1.0 / std::numbers::sqrt2, exponent);
}

CauchyCells::Powers CauchyCells::find(
    const CauchyCell& cell, const std::function<Eigen::MatrixXcd()>& expanded) {
  {
    const std::lock_guard lock(guard_);
    const auto found = known_.find(cell);
    if (found != known_.end()) return found->second;
  }
  Powers powers = std::make_shared<const Eigen::MatrixXcd>(expanded());
  const std::lock_guard lock(guard_);
  if (known_.size() >= most_known) known_.clear();
  known_.emplace(cell, powers);
  return powers;
}

}  // namespace tapfit::modal
