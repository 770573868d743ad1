#include "updating/frf_model/test_as_done.hpp"

#include <algorithm>

namespace tapfit::updating {

TestAsDone test_as_done(const effects::TestContext& context,
                        const std::vector<EffectInstance>& effects) {
  const bool right = std::ranges::none_of(effects, [](const auto& placed) {
    return placed.effect->entry() == effects::Entry::Measurement;
  });
  TestAsDone done{context};
  if (right) return done;
  auto sheet = std::make_unique<acquisition::TestBundle>(*context.bundle);
  for (const EffectInstance& placed : effects) {
    if (placed.effect->entry() != effects::Entry::Measurement) continue;
    placed.effect->correct(placed.where, *context.bundle, *sheet);
  }
  done.sheet = std::move(sheet);
  done.context.bundle = done.sheet.get();
  return done;
}

PairEnds ends_as_done(const MeasuredPair& pair,
                      const acquisition::TestBundle& written,
                      const acquisition::TestBundle& done) {
  const acquisition::Run& run = written.runs.at(pair.run);
  const acquisition::Run& real = done.runs.at(pair.run);
  PairEnds ends = pair.written;
  if (run.hammer.dof == ends.reference) ends.reference = real.hammer.dof;
  for (std::size_t k = 0; k < run.sensors.size(); ++k) {
    const acquisition::Placement& sensor = run.sensors[k];
    const std::string& channel = written.channels[sensor.channel].name;
    if (channel != pair.channel || sensor.dof != pair.written.response) {
      continue;
    }
    ends.response = real.sensors[k].dof;
  }
  return ends;
}

}  // namespace tapfit::updating
