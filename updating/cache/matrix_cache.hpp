// The room updating/cache. What is dear to compute, kept on disk from run to
// run.
// In:  Matrices, and the data that they follow from.
// Out: The same matrices again as long as data and program are the same. A
//      damaged or foreign file counts as none.
// May include: its row in CONTRIBUTING.md.
//
// Keeps on disk the matrices that are dear to compute, named by the digest of
// what they follow from.
//
// A file is a head (what it is, its key, sizes, a digest of the numbers) and
// the numbers as they stand in memory: what is read is to the bit what was
// written. It is written under another name and renamed, so that whoever reads
// sees a whole file or none. Nothing here is ever an error: a file that is
// damaged or foreign is none, and where nothing can be written nothing is kept.
#pragma once

#include "updating/cache/content_digest.hpp"

#include <Eigen/Core>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

namespace tapfit::updating {

struct MatrixCache {
  std::filesystem::path folder;  ///< made when it is first written to
  std::uintmax_t limit = std::uintmax_t{1} << 30U;  ///< of all files [bytes]

  /// The matrices kept under the key; empty where there are none that can be
  /// trusted. Marks them as used.
  [[nodiscard]] std::optional<std::vector<Eigen::MatrixXd>> load(
      const Digest& key) const;

  /// Keeps the matrices, and drops those least recently used beyond the limit.
  /// @return whether they are kept now
  bool store(const Digest& key,
             const std::vector<Eigen::MatrixXd>& matrices) const;
};

/// In acquisition::cache_folder(), where there is one.
[[nodiscard]] std::optional<MatrixCache> user_cache();

}  // namespace tapfit::updating
