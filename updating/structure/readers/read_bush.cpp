// CBUSH and PBUSH: stiffness and damping; axes from CID, GO or a vector; the
// place S between the grids.
#include "updating/structure/cards/bulk_lines.hpp"
#include "updating/structure/cards/bulk_numbers.hpp"
#include "updating/structure/readers/deck_builder.hpp"

#include <Eigen/Geometry>
#include <fmt/format.h>

namespace tapfit::structure {
namespace {

// Columns x along the element, y in the plane of the orientation vector.
Eigen::Matrix3d oriented_axes(const DeckBuilder& builder,
                              const CardReader& card,
                              const Eigen::Vector3d& a,
                              const Eigen::Vector3d& along) {
  Eigen::Vector3d v;
  if (parse_integer(card.text(5)) && card.blank(6) && card.blank(7)) {
    v = builder.grid(card, card.id(5, "GO")).position - a;
  } else {
    v = builder.grid(card, card.id(3, "GA")).axes *
        card.vector(5, "orientation");
  }
  const Eigen::Vector3d z = along.cross(v);
  if (!(z.norm() > 1e-8 * along.norm() * v.norm()) || z.isZero(0.0)) {
    card.fail("the element has no axes",
              "Give CID, or a vector (or GO) off the line between two grids "
              "that lie apart.");
  }
  Eigen::Matrix3d axes;
  axes << along.normalized(), z.normalized().cross(along.normalized()),
      z.normalized();
  return axes;
}

}  // namespace

void read_pbush(DeckBuilder& builder, const CardReader& card) {
  BushProperty property;
  for (std::size_t at = 2; at < card.size(); at += 8) {
    const std::string kind = upper(card.text(at));
    if (kind == "K" || kind == "B") {
      auto& values = kind == "K" ? property.stiffness : property.damping;
      for (std::size_t c = 0; c < 6; ++c) {
        values[c] = card.real_or(at + 1 + c, 0.0, kind.c_str());
        if (kind == "B" && !(values[c] >= 0.0)) {
          card.fail(
              fmt::format("B{} = {} drives the structure instead of damping it",
                          c + 1,
                          values[c]),
              "Give a damping of zero or more.");
        }
      }
    } else if (!kind.empty() && kind != "RCV") {
      builder.warn(card,
                   fmt::format("\"{}\" is ignored, only K and B count", kind));
    }
  }
  const int id = card.id(1, "PID");
  builder.define(card, "PBUSH", id);
  builder.bush_properties[id] = property;
}

void read_cbush(DeckBuilder& builder, const CardReader& card) {
  Bush bush;
  bush.id = card.id(1, "EID");
  builder.claim(card, bush.id);
  const int pid = card.integer_or(2, bush.id, "PID");
  const BushProperty& property = builder.bush_properties.at(
      property_of(card, builder.bush_properties, pid, "PBUSH"));
  bush.stiffness = property.stiffness;
  bush.damping = property.damping;
  const Grid& a = builder.grid(card, card.id(3, "GA"));
  bush.grids[0] = a.id;
  Eigen::Vector3d along = Eigen::Vector3d::Zero();
  if (!card.blank(4)) {
    const Grid& b = builder.grid(card, card.id(4, "GB"));
    bush.grids[1] = b.id;
    along = b.position - a.position;
  }
  const double S = card.real_or(9, 0.5, "S");
  if (card.integer_or(10, -1, "OCID") != -1) {
    builder.warn(card, "OCID is ignored: the spring lies between its grids");
  }
  bush.arms = {S * along, (S - 1.0) * along};
  bush.axes = card.blank(8) ? oriented_axes(builder, card, a.position, along)
                            : builder.system(card, card.integer(8, "CID"))
                                  .directions(a.position + S * along);
  builder.deck.bushes.push_back(bush);
}

}  // namespace tapfit::structure
