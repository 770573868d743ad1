#include "tui/report/session_report.hpp"

#include "acquisition/bundle/channel_names.hpp"
#include "acquisition/foundation/input_error.hpp"
#include "tui/report/before_after.hpp"
#include "tui/report/effect_output.hpp"
#include "tui/report/frf_text.hpp"
#include "tui/report/hits_text.hpp"
#include "tui/report/modes_text.hpp"
#include "tui/report/text_table.hpp"
#include "tui/report/update_output.hpp"
#include "tui/screen/number.hpp"
#include "tui/widgets/bars.hpp"
#include "updating/fit/kept_fit.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>

namespace tapfit::tui {
namespace {

using updating::Comparison;

std::string block(const std::string& title, const std::string& body) {
  return fmt::format("\n## {}\n\n```\n{}```\n", title, body);
}

std::string measurement(updating::Session& session, const Progress& progress) {
  std::string text;
  if (!session.bundle().runs.empty()) {
    text += block("Hits", hits_text(session.bundle(), session.hits(progress)));
  }
  text += block("FRFs", frf_text(session.frfs(progress)));
  return text + block("Modes",
                      modes_text(session.modes(progress),
                                 acquisition::channel_names(session.bundle())));
}

std::string ladder(updating::Session& session,
                   const Comparison& current,
                   const Progress& progress) {
  const std::vector<updating::Rung>& rungs = session.ladder(progress);
  double largest = 1e-9;
  for (const updating::Rung& rung : rungs) {
    largest = std::max(largest, rung.error);
  }
  TextTable table({"<error ladder", "error", "<", "<parameters"});
  for (const updating::Rung& rung : rungs) {
    const bool base = rung.added == updating::base_rung;
    const bool none = base || rung.added == updating::uncertain_rung;
    table.add({none ? rung.added + (base ? " model" : "")
                    : "+ " + effect_text(rung.added, rung.where),
               percent(rung.error),
               bar(rung.error / largest, 30, true),
               none ? "" : parameters_text(rung.parameters)});
    if (rung.stopped_after == 0) continue;
    table.add({"  " + updating::stopped_text(rung.stopped_after), "", "", ""});
  }
  table.add({"floor",
             percent(current.floor),
             fmt::format("noise {}, mesh {}",
                         percent(current.floor_noise),
                         percent(current.floor_mesh)),
             ""});
  std::string text = table.text();
  for (const updating::Estimate& p : session.model_parameters(progress)) {
    text += fmt::format("  {}\n", describe(p));
  }
  return text + "  " + current.contour + "\n";
}

/// Measured modes down, the model's across, in per cent.
std::string mac_text(const Comparison& c) {
  std::vector<std::string> heading{"measured Hz"};
  for (const double f : c.modes.frequency_hz) heading.push_back(number(f, 4));
  TextTable table(heading);
  for (Eigen::Index i = 0; i < c.mac.rows(); ++i) {
    const auto pair =
        std::find_if(c.pairs.begin(), c.pairs.end(), [i](const auto& p) {
          return p.measured == i;
        });
    std::vector<std::string> row{
        pair == c.pairs.end() ? "-" : fixed(pair->measured_hz, 3)};
    for (Eigen::Index k = 0; k < c.mac.cols(); ++k) {
      row.push_back(fixed(100.0 * c.mac(i, k), 0));
    }
    table.add(std::move(row));
  }
  return table.text();
}

std::string model(updating::Session& session, const Progress& progress) {
  const Comparison before = session.base_comparison(progress);
  const Comparison after = session.comparison(progress);
  std::string text = block("Error ladder", ladder(session, after, progress)) +
                     "\n## Modes before and after\n\n" +
                     before_after_table(before, after) +
                     block("MAC in %, base model", mac_text(before)) +
                     block("MAC in %, model now", mac_text(after));
  const auto records = session.update_records(progress);
  if (!records.empty()) text += block("Updating", updates_text(records));
  return text;
}

}  // namespace

std::string session_report(updating::Session& session,
                           const Progress& progress) {
  std::string text = fmt::format("# {}\n", session.bundle().title) +
                     measurement(session, progress);
  for (const updating::OverruledHit& hit : session.overruled()) {
    text += fmt::format(
        "\nRun {}, hit {} was judged by hand.\n", hit.run + 1, hit.hit + 1);
  }
  return text +
         (session.has_model()
              ? model(session, progress)
              : "\nThe bundle names no model: the work ends with the modes.\n");
}

void write_text_file(const std::string& text,
                     const std::filesystem::path& path) {
  std::ofstream file(path);
  file << text;
  if (!file.flush()) {
    throw InputError(
        "cannot be written", path.string(), "check folder and permissions");
  }
}

}  // namespace tapfit::tui
