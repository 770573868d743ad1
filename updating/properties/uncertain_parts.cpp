#include "updating/properties/uncertain_parts.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "updating/properties/uncertain_property.hpp"
#include "updating/structure/assembly/assemble.hpp"
#include "updating/structure/readers/matrix_market.hpp"

#include <Eigen/LU>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

namespace tapfit::updating {
namespace {

using acquisition::UncertainProperty;
using structure::Deck;
using structure::SparseMatrix;

using Powers = std::vector<int>;
using Expansion = std::map<Powers, SparseMatrix>;
using Assemble = SparseMatrix (*)(const Deck&, const std::function<bool(int)>&);

// f - 1 where the matrices are taken; halves and doubles are exact in binary.
constexpr std::array<double, 5> nodes = {0.0, 1.0, -0.5, 0.5, -0.25};

// Coefficients from values at the first degree + 1 nodes.
Eigen::MatrixXd interpolation(int degree) {
  Eigen::MatrixXd V(degree + 1, degree + 1);
  for (int n = 0; n <= degree; ++n) {
    for (int a = 0; a <= degree; ++a) {
      V(n, a) = std::pow(nodes.at(static_cast<std::size_t>(n)), a);
    }
  }
  return V.inverse();
}

// How a kind of matrix is had, and the degree of each property in it.
struct Kind {
  std::vector<int> degree;
  Assemble assemble;
};

// Elements on which the same properties act; these multiply there.
struct Group {
  std::vector<std::size_t> properties;
  std::set<int> elements;
};

std::vector<Group> grouped(const std::vector<PropertyLaw>& laws,
                           const std::vector<int>& degree) {
  std::map<int, std::vector<std::size_t>> of_element;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    if (degree[j] == 0) continue;
    for (const int id : laws[j].elements) of_element[id].push_back(j);
  }
  std::map<std::vector<std::size_t>, std::set<int>> alike;
  for (const auto& [id, properties] : of_element) {
    alike[properties].insert(id);
  }
  std::vector<Group> groups;
  groups.reserve(alike.size());
  for (const auto& [properties, ids] : alike)
    groups.push_back({properties, ids});
  return groups;
}

/// Takes matrices of a group at all combinations of its properties' nodes.
struct Expander {
  const std::vector<UncertainProperty>& uncertain;
  const Kind& kind;
  const Group& group;

  [[nodiscard]] Expansion expand(const Deck& deck, std::size_t k) const {
    if (k == group.properties.size()) {
      const auto own = [this](int id) { return group.elements.contains(id); };
      return {{Powers(uncertain.size(), 0), kind.assemble(deck, own)}};
    }
    const std::size_t j = group.properties[k];
    const Eigen::MatrixXd weights = interpolation(kind.degree[j]);
    Expansion result;
    for (int n = 0; n <= kind.degree[j]; ++n) {
      Deck scaled = deck;
      scale_property(
          scaled, uncertain[j], 1.0 + nodes.at(static_cast<std::size_t>(n)));
      for (const auto& [power, A] : expand(scaled, k + 1)) {
        for (int a = 0; a <= kind.degree[j]; ++a) {
          Powers higher = power;
          higher[j] = a;
          auto [it, fresh] = result.try_emplace(higher, A.rows(), A.cols());
          it->second += weights(a, n) * A;
        }
      }
    }
    return result;
  }
};

// Without the nominal matrix, and without what is rounding beside it.
Expansion expansion(const Deck& deck,
                    const std::vector<UncertainProperty>& uncertain,
                    const std::vector<PropertyLaw>& laws,
                    const Kind& kind) {
  Expansion all;
  for (const Group& group : grouped(laws, kind.degree)) {
    const Expander expander{uncertain, kind, group};
    Expansion own = expander.expand(deck, 0);
    const Powers nominal(uncertain.size(), 0);
    const double size = own.at(nominal).norm();
    own.erase(nominal);
    std::erase_if(own, [size](const auto& entry) {
      return entry.second.norm() <= 1e-12 * size;
    });
    for (const auto& [power, A] : own) {
      auto [it, fresh] = all.try_emplace(power, A.rows(), A.cols());
      it->second += A;
    }
  }
  return all;
}

std::vector<PropertyLaw> laws_of(
    const Deck& deck, const std::vector<UncertainProperty>& uncertain) {
  std::vector<PropertyLaw> laws;
  for (std::size_t k = 0; k < uncertain.size(); ++k) {
    const UncertainProperty& u = uncertain[k];
    const std::string place = fmt::format("test.json: uncertain[{}]", k);
    laws.push_back(property_law(deck, u, place));
    for (std::size_t i = 0; i < k; ++i) {
      if (laws[i].name != laws[k].name || uncertain[i].card != u.card) continue;
      throw InputError(
          fmt::format("{} of {} {} is listed twice", u.property, u.card, u.id),
          place,
          "keep one of the two");
    }
  }
  return laws;
}

// Of given matrices: all stiffness, or all mass.
std::vector<UncertainPart> whole_matrices(
    const structure::GivenMatrices& given,
    const std::vector<PropertyLaw>& laws) {
  const SparseMatrix none(given.K.rows(), given.K.cols());
  std::vector<UncertainPart> parts;
  for (std::size_t j = 0; j < laws.size(); ++j) {
    UncertainPart part{Powers(laws.size(), 0), none, none};
    part.power[j] = 1;
    if (laws[j].stiffness_degree > 0) {
      part.K = given.K;
    } else {
      part.M = given.M;
    }
    parts.push_back(std::move(part));
  }
  return parts;
}

}  // namespace

double part_coefficient(const std::vector<int>& power,
                        const std::vector<double>& factor) {
  double c = 1.0;
  for (std::size_t j = 0; j < power.size(); ++j) {
    for (int a = 0; a < power[j]; ++a) c *= factor[j] - 1.0;
  }
  return c;
}

double part_slope(const std::vector<int>& power,
                  const std::vector<double>& factor,
                  std::size_t j) {
  if (j >= power.size() || power[j] == 0) return 0.0;
  std::vector<int> lower = power;
  --lower[j];
  return power[j] * part_coefficient(lower, factor);
}

std::vector<UncertainPart> uncertain_parts(
    const Deck& deck, const std::vector<UncertainProperty>& uncertain) {
  const std::vector<PropertyLaw> laws = laws_of(deck, uncertain);
  if (deck.given) return whole_matrices(*deck.given, laws);
  Kind stiffness{{}, &structure::assemble_stiffness};
  Kind mass{{}, &structure::assemble_mass};
  for (const PropertyLaw& law : laws) {
    stiffness.degree.push_back(law.stiffness_degree);
    mass.degree.push_back(law.mass_degree);
  }
  std::map<Powers, UncertainPart> parts;
  for (const auto& [power, A] : expansion(deck, uncertain, laws, stiffness)) {
    parts[power].K = A;
  }
  for (const auto& [power, A] : expansion(deck, uncertain, laws, mass)) {
    parts[power].M = A;
  }
  const auto n = static_cast<Eigen::Index>(6 * deck.grids.size());
  std::vector<UncertainPart> result;
  result.reserve(parts.size());
  for (auto& [power, part] : parts) {
    part.power = power;
    if (part.K.rows() == 0) part.K.resize(n, n);
    if (part.M.rows() == 0) part.M.resize(n, n);
    result.push_back(std::move(part));
  }
  return result;
}

}  // namespace tapfit::updating
