#include "updating/structure/readers/dof_relations.hpp"

#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace tapfit::structure {

Row6 rigid_share(const Grid& grid,
                 int component,
                 const Eigen::Vector3d& about) {
  const Eigen::Vector3d a = grid.axes.col((component - 1) % 3);
  Row6 share = Row6::Zero();
  if (component > 3) {
    share.tail<3>() = a.transpose();
  } else {
    const Eigen::Vector3d r = grid.position - about;
    share.head<3>() = a.transpose();
    share.tail<3>() = r.cross(a).transpose();
  }
  return share;
}

std::vector<std::size_t> filled_fields(const CardReader& card,
                                       std::size_t first) {
  std::vector<std::size_t> fields;
  for (std::size_t at = first; at < card.size(); ++at) {
    if (!card.blank(at)) fields.push_back(at);
  }
  return fields;
}

void add_components(const DeckBuilder& builder,
                    const CardReader& card,
                    int grid,
                    const std::string& components,
                    double weight,
                    std::vector<RelationDof>& dofs) {
  if (builder.grid(card, grid).scalar) {
    card.fail(fmt::format("{} is a scalar point, which has no place", grid),
              "Name a GRID.");
  }
  for (const char digit : components) {
    dofs.push_back({grid, digit - '0', weight});
  }
}

std::vector<RelationDof> read_pairs(const DeckBuilder& builder,
                                    const CardReader& card,
                                    const std::vector<std::size_t>& fields) {
  std::vector<RelationDof> dofs;
  for (std::size_t k = 0; k + 1 < fields.size(); k += 2) {
    const int grid = existing_grid(builder, card, fields[k]);
    add_components(
        builder, card, grid, card.components(fields[k + 1]), 1.0, dofs);
  }
  return dofs;
}

void add_relation(DeckBuilder& builder,
                  const CardReader& card,
                  const RelationDof& dependent,
                  const std::vector<RelationDof>& on,
                  const Eigen::VectorXd& factors) {
  Relation relation{dependent.grid, dependent.component, {}, card.where()};
  const double most = factors.size() == 0 ? 0.0 : factors.cwiseAbs().maxCoeff();
  for (std::size_t k = 0; k < on.size(); ++k) {
    const double factor = factors(static_cast<Eigen::Index>(k));
    if (std::abs(factor) <= 1e-13 * most) continue;
    relation.terms.push_back({on[k].grid, on[k].component, factor});
  }
  builder.deck.relations.push_back(std::move(relation));
}

}  // namespace tapfit::structure
