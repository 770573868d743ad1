// Universal files in all the ways they are read: as a bundle with its time
// records, geometry and shapes, FRFs.
#include "acquisition/bundle/recording.hpp"
#include "acquisition/bundle/run_reader.hpp"
#include "acquisition/bundle/uff_bundle.hpp"
#include "acquisition/uff/uff_geometry.hpp"
#include "acquisition/uff/uff_shapes.hpp"
#include "signal/files/uff58.hpp"
#include "tests/fuzz/fuzz_file.hpp"

namespace {

using namespace tapfit;

void read_parts(const std::filesystem::path& path) {
  const acquisition::UffFile file = acquisition::open_uff(path);
  acquisition::UffGeometry geometry;
  for (const acquisition::UffDataset& dataset : file.datasets) {
    add_geometry(dataset, geometry);
    if (dataset.type == 58) {
      (void)check_function(dataset);
      (void)read_function(dataset);
    }
    if (dataset.type == 55 || dataset.type == 2414) (void)read_shape(dataset);
  }
}

void read_bundle(const std::filesystem::path& path) {
  const acquisition::TestBundle bundle = acquisition::read_uff_bundle(path);
  if (!bundle.runs.empty()) (void)read_recordings(bundle);
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  for (const auto& read : {&read_parts, &read_bundle}) {
    tapfit::fuzz::read_as("file.uff", data, size, read);
  }
  return tapfit::fuzz::read_as("file.uff", data, size, [](const auto& file) {
    (void)tapfit::signal::read_frfs_uff(file);
  });
}
