#include "tui/app/import_offer.hpp"

#include "updating/export/output_rule_of_folder.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string_view>

namespace tapfit::tui {
namespace {

namespace fs = std::filesystem;

std::string channel_line(const char* role,
                         const acquisition::ImportChannel& channel) {
  return fmt::format("{}: \"{}\" at {}, {}{}",
                     role,
                     channel.channel.empty() ? channel.column : channel.channel,
                     name(channel.dof),
                     acquisition::name(channel.quantity),
                     channel.unit.empty() ? "" : " in " + channel.unit);
}

}  // namespace

bool is_recording(const fs::path& file) {
  constexpr std::array<std::string_view, 10> endings{".csv",
                                                     ".flac",
                                                     ".h5",
                                                     ".hdf5",
                                                     ".mat",
                                                     ".nc",
                                                     ".npy",
                                                     ".npz",
                                                     ".tdms",
                                                     ".wav"};
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char c) {
    return static_cast<char>(std::tolower(c));
  });
  std::error_code fault;
  return std::ranges::find(endings, ending) != endings.end() &&
         fs::is_regular_file(file, fault);
}

ImportOffer offer_import(const fs::path& file) {
  acquisition::ImportOptions options;
  options.files.push_back({.file = file, .hammer = std::nullopt});
  options.folder = file.parent_path() / file.stem();
  options.rule = updating::output_rule_of_folder(options.folder, false);
  acquisition::check_import(options);
  return {acquisition::propose_import(options)};
}

std::vector<std::string> lines_of(const ImportOffer& offer) {
  const acquisition::ImportOptions& options = offer.proposal.options;
  std::vector<std::string> lines{
      fmt::format("becomes the test {}/", options.folder.filename().string()),
      ""};
  lines.push_back(channel_line("hammer", options.hammer));
  for (const acquisition::ImportChannel& sensor : options.sensors) {
    lines.push_back(channel_line("sensor", sensor));
  }
  for (const std::string& found : offer.proposal.found) lines.push_back(found);
  for (const acquisition::ImportAssumption& it : offer.proposal.assumptions) {
    lines.push_back("assumed: " + it.what);
    if (!it.field.empty()) {
      lines.push_back("to say otherwise: " + it.field + " in test.json");
    } else if (!it.option.empty()) {
      lines.push_back("to say otherwise: tapfit import FILE " + it.option);
    }
  }
  lines.insert(lines.end(), {"", "Enter makes it and opens it; Esc leaves it"});
  return lines;
}

fs::path accept(const ImportOffer& offer) {
  return acquisition::import_recordings(offer.proposal.options).folder;
}

}  // namespace tapfit::tui
