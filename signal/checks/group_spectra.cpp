#include "signal/checks/group_spectra.hpp"

#include "acquisition/foundation/parallel.hpp"
#include "signal/estimate/estimate_frfs.hpp"

#include <utility>

namespace tapfit::signal {

GroupSpectra group_spectra(
    const acquisition::TestBundle& bundle,
    const std::vector<acquisition::Recording>& recordings,
    const acquisition::HitSet& hits,
    const acquisition::RunGroup& group) {
  const FrfPlan plan = plan_frfs(bundle, hits, {});
  const RealFft fft(hits.block);
  GroupSpectra result;
  result.s = plan.s;
  const acquisition::Run& like = bundle.runs[group.front()];
  for (const acquisition::Placement& sensor : like.sensors) {
    result.channels.push_back(sensor.channel);
  }
  std::vector<Spectra> spectra(group.size());
  std::vector<std::vector<LineNoise>> noise(group.size());
  for_each_parallel(group.size(), [&](std::size_t g) {
    const std::size_t r = group[g];
    const HitBlocks blocks = cut_hits(arranged_as(like, bundle.runs[r]),
                                      recordings[r],
                                      hits,
                                      hits.runs[r],
                                      plan.blocks);
    if (blocks.force.cols() == 0) return;
    noise[g] = line_noise(plan.s, blocks);
    spectra[g] = fft_spectra(blocks, fft, plan.sigma, plan.first, plan.last);
  });
  for (std::size_t g = 0; g < group.size(); ++g) {
    if (spectra[g].force.cols() == 0) continue;
    const std::size_t r = group[g];
    for (std::size_t k = 0; k < hits.runs[r].size(); ++k) {
      if (!hits.runs[r][k].accepted) continue;
      result.hits.push_back({r, k});
      result.noise_of.push_back(result.noise.size());
    }
    result.noise.push_back(std::move(noise[g]));
  }
  result.spectra = side_by_side(std::move(spectra));
  return result;
}

}  // namespace tapfit::signal
