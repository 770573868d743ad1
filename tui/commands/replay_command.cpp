#include "acquisition/bundle/read_test_bundle.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "acquisition/hits/readable_recordings.hpp"
#include "signal/estimate/replay.hpp"
#include "signal/files/uff58.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/options/standard_streams.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/hits_text.hpp"
#include "tui/report/json_text.hpp"
#include "updating/export/point_geometry.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include <unistd.h>

namespace tapfit::tui {
namespace {

// One line a hit, as it comes.
void show(const acquisition::TestBundle& bundle, const signal::LiveHit& now) {
  std::vector<std::string> reasons;
  for (const auto fault : now.hit.reasons) reasons.push_back(name(fault));
  // Only there is a line of progress to be overwritten.
  const bool terminal = isatty(STDERR_FILENO) != 0;
  say(fmt::format("{}{}  {:.3f} s  {:.4g} N  {}\n",
                  terminal ? "\r\x1b[K" : "",
                  bundle.runs[now.run].file.filename().string(),
                  now.hit.time_s,
                  now.hit.peak_n,
                  now.hit.accepted
                      ? fmt::format("average of {}", now.averaged)
                      : fmt::format("rejected: {}", fmt::join(reasons, ", "))));
}

}  // namespace

std::string replay_command(const CommandOptions& options,
                           const Progress& progress) {
  const acquisition::TestBundle bundle =
      acquisition::read_test_bundle(options.input);
  acquisition::check_run_files(bundle, acquisition::Unreadable::Refused);
  if (bundle.runs.empty()) {
    throw InputError("the bundle holds no recording",
                     options.input.string(),
                     "replay a bundle with `runs`");
  }
  for (const std::string& warning : bundle.warnings) {
    say(fmt::format("note: {}\n", warning));
  }
  check_outputs(bundle, options);
  signal::ReplayOptions replay_options;
  replay_options.speed = options.speed;
  const signal::Replayed result = signal::replay(
      bundle,
      replay_options,
      [&](const signal::LiveHit& now) { show(bundle, now); },
      progress);
  if (options.uff) {
    updating::Session session(options.input);
    signal::write_frfs_uff(result.frfs,
                           bundle.title,
                           *options.uff,
                           output_rule(bundle, options),
                           signal::FrfForm::Accelerance,
                           updating::point_geometry(session));
  }
  if (!options.json) {
    return hits_text(bundle, result.hits) + "\n" + frf_text(result.frfs);
  }
  nlohmann::ordered_json json = hits_json(bundle, result.hits);
  json["frf"] = frf_json(result.frfs);
  return json_text(json);
}

}  // namespace tapfit::tui
