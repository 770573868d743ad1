// The angle of thick bars (bar_frame.hpp) with a made-up hammer test and its
// base on the split mesh, with the forms that its deck lacks.
#pragma once

#include "acquisition/bundle/test_bundle.hpp"
#include "tests/acquisition/support/temporary_folder.hpp"
#include "tests/updating/support/bar_frame.hpp"
#include "updating/effects/effect.hpp"
#include "updating/frf_model/acted_points.hpp"
#include "updating/reduction/reduced_base.hpp"
#include "updating/structure/deck/deck.hpp"
#include "updating/structure/readers/scale_units.hpp"

#include <array>
#include <string>
#include <vector>

namespace tapfit::support {

inline constexpr std::array<double, 2> frame_band_hz{20.0, 2000.0};

/// Two accelerometers, five points that are hit; E is uncertain by 3 %.
inline acquisition::TestBundle frame_bundle() {
  acquisition::TestBundle bundle;
  bundle.folder = ".";
  for (const char* name : {"hammer", "acc1", "acc2"}) {
    acquisition::Channel channel;
    channel.name = name;
    channel.quantity = bundle.channels.empty()
                           ? acquisition::Quantity::Force
                           : acquisition::Quantity::Acceleration;
    bundle.channels.push_back(channel);
  }
  for (const int node : {15, 7, 4, 9, 12}) {
    acquisition::Run run;
    run.hammer = {0, {node, 3, 1}};
    run.sensors = {{1, {15, 3, 1}}, {2, {7, 3, 1}}};
    bundle.runs.push_back(run);
  }
  bundle.band_hz = frame_band_hz;
  bundle.uncertain.push_back({"material", 1, "E", 3.0});
  return bundle;
}

inline structure::Deck frame_deck(const std::string& text,
                                  const std::string& units = "SI") {
  const tapfit::testing::TemporaryFolder folder;
  structure::Deck deck = structure::read_deck(folder.write("frame.bdf", text));
  structure::scale_to_si(deck, units);
  return deck;
}

inline updating::BaseBuilder frame_builder(
    const structure::Deck& deck,
    const acquisition::TestBundle& bundle,
    bool split) {
  updating::BaseOptions options;
  options.high_hz = frame_band_hz[1];
  options.split = split;
  const updating::MeasuredPoints points =
      updating::measured_points(deck, bundle);
  options.points = points.all;
  options.driven = points.driven;
  return {deck, bundle.uncertain, options, Progress{}};
}

struct BasedFrame {
  structure::Deck deck = frame_deck(frame_text());
  acquisition::TestBundle bundle = frame_bundle();
  updating::BaseBuilder coarse = frame_builder(deck, bundle, false);
  updating::BaseBuilder builder = frame_builder(deck, bundle, true);
  std::vector<updating::Correction> corrections =
      builder.hold_corrections(coarse);

  [[nodiscard]] effects::TestContext context() const {
    effects::TestContext context;
    context.bundle = &bundle;
    context.deck = &deck;
    context.mass_kg = builder.mass_kg();
    context.low_hz = frame_band_hz[0];
    context.high_hz = frame_band_hz[1];
    context.component = 3;
    return context;
  }
};

}  // namespace tapfit::support
