#include "signal/mass_removal/mass_removal.hpp"

#include <Eigen/Dense>

#include <algorithm>
#include <complex>

namespace tapfit::signal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

/// Below this share of its own terms a sum is rounding alone.
constexpr double singular = 1e-12;

/// Derivative of A0 to each measurement and each mass, gathered on one line.
class Derivatives {
 public:
  explicit Derivatives(const MassRemoval& removal) {
    add_source(removal.wanted);
    for (const auto* part : {&removal.row, &removal.column, &removal.core}) {
      for (const LoadedEntry& entry : *part) add_source(entry);
    }
    for (const std::size_t mass : removal.mass) {
      masses_ = std::max(masses_, mass + 1);
    }
  }

  void start() {
    to_source_.assign(entries_.size(), 0.0);
    to_mass_.assign(masses_, 0.0);
  }
  void add(const LoadedEntry& entry, const Complex& derivative) {
    to_source_[index_of(entry)] += entry.sign * derivative;
  }
  void add_mass(std::size_t mass, const Complex& times_sd) {
    to_mass_[mass] += times_sd;
  }
  [[nodiscard]] double variance(Index line) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < entries_.size(); ++i) {
      const Eigen::VectorXd& own = *entries_[i].variance;
      if (own.size() > 0) sum += std::norm(to_source_[i]) * own(line);
    }
    for (const Complex& part : to_mass_) sum += std::norm(part);
    return sum;
  }

 private:
  [[nodiscard]] std::size_t index_of(const LoadedEntry& entry) const {
    const auto own = std::find_if(
        entries_.begin(), entries_.end(), [&](const LoadedEntry& other) {
          return other.source == entry.source;
        });
    return static_cast<std::size_t>(own - entries_.begin());
  }
  void add_source(const LoadedEntry& entry) {
    if (index_of(entry) == entries_.size()) entries_.push_back(entry);
  }

  std::vector<LoadedEntry> entries_;  // one of each source
  std::size_t masses_ = 0;
  std::vector<Complex> to_source_;
  std::vector<Complex> to_mass_;
};

Complex at(const LoadedEntry& entry, Index line) {
  return entry.sign * (*entry.H)(line);
}

Eigen::VectorXcd values(const std::vector<LoadedEntry>& entries, Index line) {
  Eigen::VectorXcd result(static_cast<Index>(entries.size()));
  for (Index k = 0; k < result.size(); ++k) {
    result(k) = at(entries[static_cast<std::size_t>(k)], line);
  }
  return result;
}

/// r and c of the head of the file; empty when there are none.
struct Sides {
  Eigen::VectorXcd r;
  Eigen::VectorXcd c;
};

std::optional<Sides> solve_sides(const MassRemoval& removal, Index line) {
  const Index k = removal.kg.size();
  const Eigen::VectorXcd flat = values(removal.core, line);
  const Eigen::MatrixXcd A_TT =
      Eigen::Map<const Eigen::MatrixXcd>(flat.data(), k, k).transpose();
  // Scaled by the masses' roots, where the mass of one kilogram is no measure.
  const Eigen::VectorXd root = removal.kg.cwiseSqrt();
  const Eigen::MatrixXcd scaled = root.asDiagonal() * A_TT * root.asDiagonal();
  const Eigen::MatrixXcd core = Eigen::MatrixXcd::Identity(k, k) - scaled;
  const Eigen::FullPivLU<Eigen::MatrixXcd> lu(core);
  const double least = lu.matrixLU().diagonal().cwiseAbs().minCoeff();
  if (!(least > singular * (1.0 + scaled.norm()))) return std::nullopt;
  const Eigen::MatrixXcd inverse = lu.inverse();
  const Eigen::VectorXcd right =
      root.cwiseProduct(values(removal.column, line));
  const Eigen::VectorXcd left = root.cwiseProduct(values(removal.row, line));
  Sides sides;
  sides.c = root.cwiseProduct(inverse * right);
  sides.r = root.cwiseProduct(inverse.transpose() * left);
  return sides;
}

void gather(const MassRemoval& removal,
            const Sides& sides,
            Derivatives& derivatives) {
  derivatives.start();
  derivatives.add(removal.wanted, 1.0);
  const Index k = removal.kg.size();
  for (Index t = 0; t < k; ++t) {
    const auto i = static_cast<std::size_t>(t);
    derivatives.add(removal.row[i], sides.c(t));
    derivatives.add(removal.column[i], sides.r(t));
    for (Index u = 0; u < k; ++u) {
      derivatives.add(removal.core[i * static_cast<std::size_t>(k) +
                                   static_cast<std::size_t>(u)],
                      sides.r(t) * sides.c(u));
    }
    derivatives.add_mass(removal.mass[i],
                         sides.r(t) * sides.c(t) * removal.sd_kg(t) /
                             (removal.kg(t) * removal.kg(t)));
  }
}

}  // namespace

std::optional<FreedCurve> remove_masses(const MassRemoval& removal) {
  const Index lines = removal.wanted.H->size();
  FreedCurve freed{Eigen::VectorXcd(lines), Eigen::VectorXd(lines)};
  Derivatives derivatives(removal);
  for (Index line = 0; line < lines; ++line) {
    const std::optional<Sides> sides = solve_sides(removal, line);
    if (!sides) return std::nullopt;
    const Eigen::VectorXcd row = values(removal.row, line);
    freed.H(line) = at(removal.wanted, line) + row.cwiseProduct(sides->c).sum();
    gather(removal, *sides, derivatives);
    freed.variance(line) = derivatives.variance(line);
  }
  return freed;
}

}  // namespace tapfit::signal
