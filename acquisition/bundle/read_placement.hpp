// Where a channel is, as test.json says it: a grid or coordinates, a direction
// and a height.
#pragma once

#include "acquisition/bundle/json_source.hpp"
#include "acquisition/bundle/point_table.hpp"
#include "acquisition/bundle/test_bundle.hpp"

#include <nlohmann/json_fwd.hpp>

#include <string>

namespace tapfit::acquisition {

class PlacementReader {
 public:
  /// @param bundle with its channels, units and geometry
  /// Both outlive this object.
  PlacementReader(const TestBundle& bundle, const JsonSource& source);

  /// @param entry of the schema's form
  /// @param place of the entry, "runs[2].hammer"
  /// @throws InputError for a channel that is not there, no place or two, a
  ///   direction that is none or of no length
  [[nodiscard]] Placement read(const nlohmann::json& entry,
                               const std::string& place);

  /// Those of the test's own, of all placements that were read.
  [[nodiscard]] std::vector<TestPoint> points() const {
    return table_.points();
  }

 private:
  struct Site;
  [[nodiscard]] Site read_site(const nlohmann::json& entry,
                               const std::string& place) const;
  [[nodiscard]] Dof read_dof(const nlohmann::json& entry,
                             const std::string& place,
                             double height_m);
  [[nodiscard]] Dof at_test_node(const Site& site,
                                 const nlohmann::json& direction,
                                 const std::string& place);

  const TestBundle* bundle_;
  const JsonSource* source_;
  PointTable table_;
};

}  // namespace tapfit::acquisition
