// Degrees of freedom that are sums of others, as rigid elements of shared
// components and RBE3 make them.
#pragma once

#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Core>

#include <string>
#include <vector>

namespace tapfit::structure {

using Row6 = Eigen::Matrix<double, 1, 6>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A component of a grid, along its own axes.
struct RelationDof {
  int grid = 0;
  int component = 0;    ///< 1..6
  double weight = 1.0;  ///< of RBE3
};

/// What a rigid motion about a place moves a component by: factors of its
/// translation and of its rotation [m].
[[nodiscard]] Row6 rigid_share(const Grid& grid,
                               int component,
                               const Eigen::Vector3d& about);

/// Fields from the first one on that are not blank.
[[nodiscard]] std::vector<std::size_t> filled_fields(const CardReader& card,
                                                     std::size_t first);

/// @param components digits of 1..6
/// @throws InputError for a scalar point
void add_components(const DeckBuilder& builder,
                    const CardReader& card,
                    int grid,
                    const std::string& components,
                    double weight,
                    std::vector<RelationDof>& dofs);

/// Pairs of a grid and its components.
/// @param fields of these, two by two
/// @throws InputError for a grid that does not exist or a scalar point
[[nodiscard]] std::vector<RelationDof> read_pairs(
    const DeckBuilder& builder,
    const CardReader& card,
    const std::vector<std::size_t>& fields);

/// dependent = sum of factors times `on`; factors below rounding are none.
void add_relation(DeckBuilder& builder,
                  const CardReader& card,
                  const RelationDof& dependent,
                  const std::vector<RelationDof>& on,
                  const Eigen::VectorXd& factors);

}  // namespace tapfit::structure
