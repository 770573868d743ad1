#include "tui/options/hand_choices.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "tui/options/open_bundle.hpp"
#include "tui/options/standard_streams.hpp"
#include "tui/workbench/pair_words.hpp"
#include "updating/session/saved_session.hpp"
#include "updating/session/session_file.hpp"
#include "updating/session/shared_session.hpp"

#include <fmt/format.h>

namespace tapfit::tui {
namespace {

using modal::PoleEdit;

void add_edits(CLI::App& command,
               const std::string& name,
               PoleEdit::What what,
               const std::string& does,
               updating::ModeChoices& choices) {
  command
      .add_option_function<std::vector<double>>(
          name,
          [what, &choices](const std::vector<double>& all) {
            for (const double hz : all) choices.edits.push_back({what, hz});
          },
          does)
      ->check(CLI::PositiveNumber)
      ->allow_extra_args(false);
}

std::string pair_fault(const std::string& text) {
  return parse_pair(text) ? std::string{}
                          : "\"" + text + "\" is not I:K or I:none";
}

updating::ModeChoices together(updating::ModeChoices choices,
                               const updating::ModeChoices& given) {
  if (given.band_hz) choices.band_hz = given.band_hz;
  choices.edits.insert(
      choices.edits.end(), given.edits.begin(), given.edits.end());
  return choices;
}

/// Pairs are given by number and kept by frequency.
void choose_pairs(const std::vector<std::string>& texts,
                  updating::Session& session,
                  const Progress& progress) {
  updating::ModeChoices choices = session.mode_choices();
  for (const std::string& text : texts) {
    const auto pair = parse_pair(text).value_or(modal::Pair{});
    const auto& modes = session.modes(progress).modes;
    const auto measured = static_cast<std::size_t>(pair.measured);
    if (measured >= modes.size()) {
      throw InputError(
          fmt::format("there is no measured mode {} to be paired",
                      measured + 1),
          "--pair " + text,
          fmt::format("{} were identified: see tapfit modes", modes.size()));
    }
    choices = with_pair(
        choices, {modes[measured].frequency_hz, static_cast<int>(pair.model)});
  }
  session.choose_modes(choices, progress);
}

/// Never over what another program has kept since.
void keep(updating::SharedSession& file,
          updating::SavedSession then,
          const updating::Session& session) {
  then.title = session.bundle().title;
  // What came out with other modes is no longer true.
  if (then.modes != session.mode_choices()) then.ladder.clear();
  then.modes = session.mode_choices();
  if (file.write(then)) return;
  throw InputError("another program has kept decisions there meanwhile",
                   updating::session_file(session.bundle()).string(),
                   "nothing of these was kept: give the command again");
}

/// @param file where `then` was read
/// @param then what is kept
/// @param now what of it is taken up
updating::Session taken_up(updating::Session session,
                           const HandChoices& given,
                           updating::SharedSession& file,
                           const updating::SavedSession& then,
                           updating::SavedSession now,
                           const Progress& progress) {
  now.modes = together(now.modes, given.modes);
  session.take_up(now);
  if (!given.pairs.empty()) choose_pairs(given.pairs, session, progress);
  if (given.keep) {
    static_cast<void>(session.modes(progress));  // or they are refused
    keep(file, then, session);
  }
  return session;
}

}  // namespace

void add_mode_choices(CLI::App& command, HandChoices& by_hand) {
  updating::ModeChoices& choices = by_hand.modes;
  command
      .add_option_function<std::vector<double>>(
          "--band",
          [&choices](const std::vector<double>& band) {
            if (!(band[0] < band[1])) {
              throw CLI::ValidationError(
                  "--band", "give the lower end first, as in --band 5 60");
            }
            choices.band_hz = {band[0], band[1]};
          },
          "Search this band only [Hz]")
      ->type_name("LOW HIGH")
      ->expected(2)
      ->delimiter(',')
      ->check(CLI::NonNegativeNumber);
  add_edits(command,
            "--drop",
            PoleEdit::What::Drop,
            "Take this mode out [Hz]; may be repeated",
            choices);
  add_edits(command,
            "--add",
            PoleEdit::What::Add,
            "Put a pole in here [Hz], after those dropped; may be repeated",
            choices);
  command.add_flag("--session",
                   by_hand.session,
                   "With the hits and modes decided by hand in the terminal "
                   "(BUNDLE/session.json)");
  command.add_flag("--keep",
                   by_hand.keep,
                   "Keep the modes decided by hand there, for the terminal "
                   "and --session");
}

void add_pair_choices(CLI::App& command, HandChoices& by_hand) {
  command
      .add_option("--pair",
                  by_hand.pairs,
                  "FIRST:SECOND or FIRST:none, modes paired by hand; may be "
                  "repeated")
      ->check(CLI::Validator(pair_fault, "I:K|I:none"))
      ->allow_extra_args(false);
}

updating::Session open_by_hand(const CommandOptions& options,
                               const Progress& progress) {
  const HandChoices& given = options.by_hand;
  updating::Session session = open_bundle(options);
  const std::filesystem::path file = updating::session_file(session.bundle());
  updating::SharedSession shared(file);
  const updating::SavedSession then =
      shared.news().value_or(updating::SavedSession{});
  updating::SavedSession now;
  if (given.session) {
    now.overruled = then.overruled;
    now.modes = then.modes;
  } else if (!then.modes.empty() || !then.overruled.empty()) {
    say(fmt::format(
        "note: {} holds decisions by hand; --session takes them over\n",
        file.string()));
  }
  return taken_up(
      std::move(session), given, shared, then, std::move(now), progress);
}

updating::Session open_as_kept(const CommandOptions& options,
                               const Progress& progress) {
  updating::Session session = open_bundle(options);
  updating::SharedSession file(updating::session_file(session.bundle()));
  const updating::SavedSession then =
      file.news().value_or(updating::SavedSession{});
  return taken_up(
      std::move(session), options.by_hand, file, then, then, progress);
}

}  // namespace tapfit::tui
