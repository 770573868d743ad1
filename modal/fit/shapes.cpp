#include "modal/fit/shapes.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "acquisition/samples/statistics.hpp"
#include "modal/fit/shape_equations.hpp"
#include "modal/mode_set/complexity.hpp"

#include <Eigen/Dense>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <map>
#include <utility>

namespace tapfit::modal {
namespace {

using Complex = std::complex<double>;
using Eigen::Index;

std::map<Dof, int> number_points(const WeightedFrfs& curves) {
  std::map<Dof, int> index;
  for (const Dof& dof : curves.response) index.emplace(dof, 0);
  for (const Dof& dof : curves.reference) index.emplace(dof, 0);
  int next = 0;
  for (auto& [dof, value] : index) value = next++;
  return index;
}

/// Sides of the points reached from a root; true when an odd cycle is met.
bool colour(const std::vector<std::pair<int, int>>& edges,
            int root,
            std::vector<int>& side) {
  side[static_cast<std::size_t>(root)] = 0;
  bool odd = false;
  for (bool grown = true; grown;) {
    grown = false;
    odd = false;
    for (const auto& [a, b] : edges) {
      int& sa = side[static_cast<std::size_t>(a)];
      int& sb = side[static_cast<std::size_t>(b)];
      if (sa >= 0 && sb >= 0) odd = odd || sa == sb;
      if ((sa >= 0) == (sb >= 0)) continue;
      (sa < 0 ? sa : sb) = 1 - (sa < 0 ? sb : sa);
      grown = true;
    }
  }
  return odd;
}

/// The connected part with the most points.
std::vector<int> largest_part(const std::vector<std::pair<int, int>>& edges,
                              std::size_t points,
                              bool& odd) {
  std::vector<int> best(points, -1);
  std::vector<bool> seen(points, false);
  std::ptrdiff_t most = 0;
  for (std::size_t root = 0; root < points; ++root) {
    if (seen[root]) continue;
    std::vector<int> side(points, -1);
    const bool found_odd = colour(edges, static_cast<int>(root), side);
    for (std::size_t p = 0; p < points; ++p) {
      if (side[p] >= 0) seen[p] = true;
    }
    const std::ptrdiff_t size =
        std::ranges::count_if(side, [](int s) { return s >= 0; });
    if (size <= most) continue;
    most = size;
    best = side;
    odd = found_odd;
  }
  return best;
}

/// The strongest of the FRFs that may be taken, or -1.
template <typename Admitted>
Index strongest(const Eigen::VectorXd& strength, const Admitted& admitted) {
  Index best = -1;
  for (Index f = 0; f < strength.size(); ++f) {
    if (!admitted(f)) continue;
    if (best < 0 || strength(f) > strength(best)) best = f;
  }
  return best;
}

/// phi by propagation along the strongest FRFs, from the sensor of the first.
/// Only from one side to the other: what is left open is then one factor t on
/// one side and 1 / t on the other, which fix_scale() can find.
Eigen::VectorXcd propagate(const ShapeGraph& graph,
                           const Eigen::VectorXcd& P,
                           const Eigen::VectorXd& weight) {
  const Eigen::VectorXd strength = P.cwiseAbs().cwiseProduct(weight);
  const auto edge = [&](Index f) {
    return graph.edges[static_cast<std::size_t>(f)];
  };
  const auto side = [&](int point) {
    return graph.side[static_cast<std::size_t>(point)];
  };
  const auto points = static_cast<Index>(graph.points.size());
  Eigen::VectorXcd phi = Eigen::VectorXcd::Zero(points);
  const Index first =
      strongest(strength, [&](Index f) { return side(edge(f).first) >= 0; });
  if (first < 0 || std::abs(P(first)) == 0.0) return phi;
  Eigen::Array<bool, Eigen::Dynamic, 1> known =
      Eigen::Array<bool, Eigen::Dynamic, 1>::Constant(points, false);
  const int root = edge(first).first;
  phi(root) = std::sqrt(std::abs(P(first)));
  known(root) = true;
  const auto leads_on = [&](Index f) {
    const auto [a, b] = edge(f);
    return known(a) != known(b) && side(a) != side(b);
  };
  for (;;) {
    const Index next = strongest(strength, leads_on);
    if (next < 0) return phi;
    auto [from, to] = edge(next);
    if (!known(from)) std::swap(from, to);
    // A point in a node of the mode cannot tell its neighbours anything.
    if (std::abs(phi(from)) > 0.0) phi(to) = P(next) / phi(from);
    known(to) = true;
  }
}

/// Turns one side by t and the other by 1 / t so that odd cycles agree.
void fix_scale(const ShapeGraph& graph,
               const Eigen::VectorXcd& P,
               const Eigen::VectorXd& weight,
               Eigen::VectorXcd& phi) {
  Complex sum = 0.0;
  double logs = 0.0;
  double total = 0.0;
  for (Index f = 0; f < P.size(); ++f) {
    const auto [a, b] = graph.edges[static_cast<std::size_t>(f)];
    const int side = graph.side[static_cast<std::size_t>(a)];
    if (side < 0 || side != graph.side[static_cast<std::size_t>(b)]) continue;
    const Complex product = phi(a) * phi(b);
    if (std::abs(product) == 0.0 || std::abs(P(f)) == 0.0) continue;
    Complex ratio = P(f) / product;  // t^2 on side 0, t^-2 on side 1
    if (side == 1) ratio = 1.0 / ratio;
    const double w = std::norm(weight(f)) * std::abs(P(f)) * std::abs(P(f));
    sum += w * ratio / std::abs(ratio);
    logs += w * std::log(std::abs(ratio));
    total += w;
  }
  if (total == 0.0) return;
  const Complex t = std::exp(0.5 * logs / total) *
                    std::sqrt(sum / std::max(std::abs(sum), 1e-300));
  for (std::size_t p = 0; p < graph.points.size(); ++p) {
    const auto i = static_cast<Index>(p);
    if (graph.side[p] == 0) phi(i) *= t;
    if (graph.side[p] == 1) phi(i) /= t;
  }
}

/// One robust Gauss-Newton step on P_ab = phi_a phi_b; smallest step where the
/// scale is free.
void polish(const ShapeGraph& graph,
            const Eigen::VectorXcd& P,
            const Eigen::VectorXd& weight,
            Eigen::VectorXcd& phi) {
  Eigen::VectorXcd r(P.size());
  for (Index f = 0; f < P.size(); ++f) {
    const auto [a, b] = graph.edges[static_cast<std::size_t>(f)];
    r(f) = P(f) - phi(a) * phi(b);
  }
  Eigen::VectorXd size = r.cwiseAbs().cwiseProduct(weight);
  const double scale = std::max(3.0 * acquisition::median(size), 1e-300);
  Eigen::VectorXd w(P.size());
  for (Index f = 0; f < P.size(); ++f) {
    w(f) = weight(f) / (1.0 + size(f) / scale);
  }
  Eigen::VectorXcd step =
      ShapeEquations({graph.edges.begin(), graph.edges.end()}, phi, w).solve(r);
  const double limit = 0.5 * phi.norm();
  if (step.norm() > limit) step *= limit / step.norm();
  if (step.allFinite()) phi += step;
}

/// The phase of a scaled shape is that of its residues; only a driving point of
/// wrong polarity, which turns phi phi by half a turn, is taken out.
Complex quarter_turn(const Eigen::VectorXcd& shape) {
  const Complex sum = (shape.array() * shape.array()).sum();
  return sum.real() < 0.0 ? Complex(0.0, -1.0) : Complex(1.0);
}

}  // namespace

ShapeGraph shape_graph(const WeightedFrfs& curves,
                       std::vector<std::string>& warnings) {
  ShapeGraph graph;
  const std::map<Dof, int> index = number_points(curves);
  for (const auto& [dof, value] : index) graph.points.push_back(dof);
  for (std::size_t f = 0; f < curves.response.size(); ++f) {
    graph.edges.emplace_back(index.at(curves.response[f]),
                             index.at(curves.reference[f]));
  }
  graph.side = largest_part(graph.edges, graph.points.size(), graph.scaled);
  const auto size = [&](int side) {
    return std::ranges::count(graph.side, side);
  };
  const int larger = size(1) > size(0) ? 1 : 0;
  for (std::size_t p = 0; p < graph.points.size(); ++p) {
    const bool keep =
        graph.scaled ? graph.side[p] >= 0 : graph.side[p] == larger;
    if (!keep) continue;
    graph.kept.push_back(static_cast<int>(p));
    graph.dofs.push_back(graph.points[p]);
  }
  if (!graph.scaled) {
    warnings.push_back(
        fmt::format("no driving-point FRF: shapes are unscaled and cover only "
                    "the {} points of one side; hit next to one of the sensors "
                    "to get both",
                    graph.dofs.size()));
  }
  if (const auto apart = std::ranges::count(graph.side, -1); apart > 0) {
    warnings.push_back(fmt::format(
        "{} no hammer or sensor with the others and {} left out of "
        "the shapes",
        apart == 1 ? "1 point shares" : fmt::format("{} points share", apart),
        apart == 1 ? "is" : "are"));
  }
  return graph;
}

Eigen::MatrixXcd mode_shapes(const ShapeGraph& graph,
                             const Eigen::MatrixXcd& residues,
                             const Eigen::VectorXcd& poles,
                             const Eigen::VectorXd& frf_weight) {
  const auto n = static_cast<Index>(graph.kept.size());
  Eigen::MatrixXcd shapes(n, poles.size());
  const auto operations = 2000.0 * static_cast<double>(residues.size());
  const auto count = static_cast<std::size_t>(poles.size());
  for_each_parallel(count, operations, [&](std::size_t k) {
    const auto r = static_cast<Index>(k);
    const Eigen::VectorXcd P =
        Complex(0.0, 2.0 * poles(r).imag()) * residues.col(r);
    Eigen::VectorXcd phi = propagate(graph, P, frf_weight);
    if (graph.scaled) fix_scale(graph, P, frf_weight, phi);
    for (int i = 0; i < 12; ++i) polish(graph, P, frf_weight, phi);
    Eigen::VectorXcd shape = phi(graph.kept);
    shape *= graph.scaled ? quarter_turn(shape) : turn_to_real(shape);
    Index largest = 0;
    shape.cwiseAbs().maxCoeff(&largest);
    if (shape(largest).real() < 0.0) shape = -shape;
    if (!graph.scaled && std::abs(shape(largest)) > 0.0) {
      shape /= std::abs(shape(largest));
    }
    shapes.col(r) = shape;
  });
  return shapes;
}

}  // namespace tapfit::modal
