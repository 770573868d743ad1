#include "acquisition/foundation/output_file.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/library_versions.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/session_report.hpp"
#include "tui/report/text_table.hpp"
#include "updating/session/added_effect.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/session/session_file.hpp"

#include <fmt/format.h>

#include <cmath>

namespace tapfit::tui {
namespace {

// Fits of the same data by the same program end within rounding.
constexpr double same = 1e-6;

// Rungs with error, mean frequency error and mean MAC of the paired modes.
std::string session_text(const updating::SavedSession& session) {
  std::string text;
  for (const updating::OverruledHit& hit :
       updating::overruled_now(session.overruled)) {
    text += fmt::format(
        "run {}, hit {}: judged manually\n", hit.run + 1, hit.hit + 1);
  }
  TextTable table({"<rung", "error", "frequencies", "MAC", "<parameters"});
  for (const updating::SavedRung& saved : session.ladder) {
    double hz_error = 0.0;
    double mac = 0.0;
    for (const updating::ModePair& pair : saved.modes) {
      const auto count = static_cast<double>(saved.modes.size());
      hz_error += std::abs(pair.error_percent) / 100.0 / count;
      mac += pair.mac / count;
    }
    const bool paired = !saved.modes.empty();
    const bool shapes = paired && saved.modes.front().has_shape;
    table.add({effect_text(saved.rung.added, saved.rung.where),
               percent(saved.rung.error),
               paired ? percent(hz_error) : "-",
               shapes ? fmt::format("{:.3f}", mac) : "-",
               estimates_text(saved.rung.parameters)});
    if (saved.rung.stopped_after == 0) continue;
    table.add({"  " + updating::stopped_text(saved.rung.stopped_after),
               "",
               "",
               "",
               ""});
  }
  text += table.text();
  for (const updating::AddedEffect& added : session.effects) {
    if (added.on) continue;
    text += "off: " + effect_text(added.ref.effect, added.ref.where) + "\n";
  }
  return text;
}

// What differs in the errors of two ladders; empty where nothing does.
std::string differences(const updating::SavedSession& then,
                        const updating::SavedSession& now) {
  if (then.ladder.empty()) return {};
  if (then.ladder.size() != now.ladder.size()) {
    return fmt::format("{} rungs were saved, {} came out\n",
                       then.ladder.size(),
                       now.ladder.size());
  }
  std::string text;
  for (std::size_t k = 0; k < now.ladder.size(); ++k) {
    const double saved = then.ladder[k].rung.error;
    const double found = now.ladder[k].rung.error;
    if (std::abs(found - saved) <= same * std::abs(saved)) continue;
    text += fmt::format("{}: error {:.6g} was saved, {:.6g} came out\n",
                        now.ladder[k].rung.added,
                        saved,
                        found);
  }
  return text;
}

}  // namespace

std::string session_command(const CommandOptions& options,
                            const Progress& progress) {
  updating::Session session = open_bundle(options);
  const updating::SavedSession then = updating::read_saved_session(
      options.saved.value_or(updating::session_file(session.bundle())));
  session.take_up(then);
  static_cast<void>(session.ladder(progress));
  const updating::SavedSession now = session.saved(progress);
  if (options.output) {
    ReportData data = report_data(session, options.input, progress);
    data.versions = library_versions();
    write_report(report_document(data),
                 *options.output,
                 output_rule(session.bundle(), options));
  }
  if (options.json) return updating::as_text(now);
  const std::string other = differences(then, now);
  return session_text(now) +
         (other.empty() ? "as saved\n" : "not as saved:\n" + other);
}

}  // namespace tapfit::tui
