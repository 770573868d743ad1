#include "acquisition/bundle/channel_names.hpp"
#include "modal/identify/identify_modes.hpp"
#include "modal/mode_set/synthesis.hpp"
#include "modal/mode_set/uff55.hpp"
#include "signal/checks/frac.hpp"
#include "signal/files/uff58.hpp"
#include "tui/commands/commands.hpp"
#include "tui/options/hand_choices.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/report/diagram_text.hpp"
#include "tui/report/json_text.hpp"
#include "tui/report/modes_text.hpp"
#include "updating/export/point_geometry.hpp"
#include "updating/session/session.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <vector>

namespace tapfit::tui {

using nlohmann::ordered_json;

namespace {

struct FittedFrf {
  const signal::Frf* frf = nullptr;
  double frac = 0.0;  ///< with the fit, on its lines
};

/// Those that took part; one that is zero throughout did not.
std::vector<FittedFrf> fitted_frfs(const signal::FrfSet& frfs,
                                   const modal::ModeSet& modes) {
  std::vector<FittedFrf> result;
  for (std::size_t f = 0; f < modes.fitted.size(); ++f) {
    const Eigen::VectorXcd& fit = modes.fitted[f];
    if (fit.isZero(0.0)) continue;
    const Eigen::VectorXcd measured =
        (fit.array().abs() > 0.0)
            .select(frfs.frfs[f].H.array(), std::complex<double>(0.0));
    result.push_back({&frfs.frfs[f], signal::frac(measured, fit)});
  }
  return result;
}

ordered_json fracs_json(const signal::FrfSet& frfs,
                        const modal::ModeSet& modes) {
  ordered_json list = ordered_json::array();
  for (const FittedFrf& fitted : fitted_frfs(frfs, modes)) {
    list.push_back({{"response", name(fitted.frf->response)},
                    {"reference", name(fitted.frf->reference)},
                    {"run", fitted.frf->run + 1},
                    {"frac", fitted.frac}});
  }
  return list;
}

std::string fracs_text(const signal::FrfSet& frfs,
                       const modal::ModeSet& modes) {
  const std::vector<FittedFrf> fitted = fitted_frfs(frfs, modes);
  if (fitted.empty()) return {};
  const auto worst = std::ranges::min_element(fitted, {}, &FittedFrf::frac);
  double sum = 0.0;
  for (const FittedFrf& one : fitted) sum += one.frac;
  return fmt::format(
      "  FRAC of the fit: {:.3f} at worst ({}), {:.3f} on average\n",
      worst->frac,
      name(*worst->frf),
      sum / static_cast<double>(fitted.size()));
}

}  // namespace

std::string modes_command(const CommandOptions& options,
                          const Progress& progress) {
  updating::Session session = open_by_hand(options, progress);
  const signal::FrfSet& frfs = session.frfs(progress);
  const ModesArguments& told = options.identification;
  modal::IdentifyOptions usual;
  usual.band_hz = session.mode_choices().band_hz;
  usual.edits = session.mode_choices().edits;
  modal::IdentifyOptions identify = told.identify;
  identify.band_hz = usual.band_hz;
  identify.edits = usual.edits;
  if (session.bundle().modes && (identify != usual || told.fit)) {
    refuse_modes(session.bundle());
  }
  modal::ModeSet modes = identify == usual
                             ? session.modes(progress)
                             : modal::identify_modes(frfs, identify, progress);
  if (!session.bundle().frfs && !session.bundle().modes) {
    std::vector<std::string> said;
    for (const Finding& finding : session.hits(progress).findings) {
      said.push_back(in_full(finding));
    }
    modes.warnings.insert(modes.warnings.begin(), said.begin(), said.end());
  }
  const std::string& title = session.bundle().title;
  if (options.uff) {
    modal::write_modes_uff(modes,
                           title,
                           *options.uff,
                           output_rule(session.bundle(), options),
                           told.dataset == 2414 ? modal::ModeDataset::Uff2414
                                                : modal::ModeDataset::Uff55,
                           updating::point_geometry(session));
  }
  if (told.fit) {
    signal::write_frfs_uff(modal::fitted_set(frfs, modes),
                           title,
                           *told.fit,
                           output_rule(session.bundle(), options),
                           signal::FrfForm::Accelerance,
                           updating::point_geometry(session));
  }
  const std::vector<std::string> channels =
      acquisition::channel_names(session.bundle());
  if (options.json) {
    ordered_json json = modes_json(modes, channels);
    json["fit"] = fracs_json(frfs, modes);
    return json_text(json);
  }
  std::string text = modes_text(modes, channels) + fracs_text(frfs, modes);
  if (told.diagram && frfs.lines() > 1) {
    const Eigen::VectorXd f = frfs.frequency_hz();
    const std::array<double, 2> band = identify.band_hz.value_or(
        std::array<double, 2>{f.minCoeff(), f.maxCoeff()});
    text += diagram_text(modes, frfs, band[0], band[1]);
  }
  return text;
}

}  // namespace tapfit::tui
