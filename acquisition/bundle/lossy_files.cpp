#include "acquisition/bundle/lossy_files.hpp"

#include "acquisition/readers/audio_file.hpp"

#include <fmt/format.h>

#include <map>

namespace tapfit::acquisition {

std::vector<std::string> lossy_statements(const TestBundle& bundle) {
  std::map<std::string, std::vector<std::string>> files;
  for (const Run& run : bundle.runs) {
    if (!run.datasets.empty()) continue;
    const std::string encoding = lossy_encoding(run.file);
    if (encoding.empty()) continue;
    files[encoding].push_back(run.file.filename().string());
  }
  std::vector<std::string> said;
  for (const auto& [encoding, names] : files) {
    const bool one = names.size() == 1;
    said.push_back(fmt::format(
        "{}{} compressed with loss ({}): FRFs are falsified, near peaks and "
        "antiresonances most, and no judgement of hits shows it. Record to PCM "
        "WAV or FLAC",
        names.front(),
        one ? " is" : fmt::format(" and {} more are", names.size() - 1),
        encoding));
  }
  return said;
}

}  // namespace tapfit::acquisition
