#include "updating/measurement/bundle_frfs.hpp"

#include "acquisition/bundle/uff_file.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/uff/uff_systems.hpp"

#include <fmt/format.h>

namespace tapfit::updating {

signal::UffFrfs read_bundle_frfs(const acquisition::TestBundle& bundle) {
  signal::UffFrfs read = signal::read_frfs_uff(*bundle.frfs);
  if (!bundle.geometry) return read;
  const acquisition::TestGeometry& geometry = *bundle.geometry;
  const acquisition::UffFile file = acquisition::open_uff(*bundle.frfs);
  const acquisition::UffGeometry own = file.bytes.reading(
      [&file] { return acquisition::read_geometry(file.datasets); });
  for (signal::Frf& frf : read.set.frfs) {
    for (Dof* dof : {&frf.response, &frf.reference}) {
      const int label = std::abs(dof->node);
      if (!geometry.nodes.contains(label)) {
        throw InputError(
            fmt::format("the test's geometry has no point {}", label),
            bundle.frfs->filename().string(),
            fmt::format("export {} with all points that were measured",
                        geometry.file.filename().string()));
      }
      if (dof->node < 0) continue;
      if (own.nodes.contains(label)) {
        dof->node = -label;
      } else {
        *dof = acquisition::at_own_point(geometry, *dof);
      }
    }
  }
  return read;
}

}  // namespace tapfit::updating
