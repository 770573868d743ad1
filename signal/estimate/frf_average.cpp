#include "signal/estimate/frf_average.hpp"

#include "signal/estimate/frf_variance.hpp"

namespace tapfit::signal {
namespace {

using acquisition::Quantity;
using Eigen::Index;

// Factor that makes an accelerance of what was measured.
Eigen::VectorXcd to_acceleration(const Eigen::VectorXcd& s, Quantity q) {
  if (q == Quantity::Velocity) return s;
  if (q == Quantity::Displacement) return s.cwiseProduct(s);
  return Eigen::VectorXcd::Ones(s.size());
}

// Mean of two, weighted by their hits.
void average_in(const LineNoise& more, double share, LineNoise& noise) {
  noise.response += share * (more.response - noise.response);
  noise.force += share * (more.force - noise.force);
  noise.bandwidth += share * (more.bandwidth - noise.bandwidth);
}

}  // namespace

void add_hits(const RunAverage& more, RunAverage& average) {
  const std::size_t sensors = more.powers.size();
  average.powers.resize(sensors);
  average.noise.resize(sensors);
  for (std::size_t c = 0; c < sensors; ++c) {
    CrossPowers& powers = average.powers[c];
    if (powers.hits == 0) average.noise[c] = more.noise[c];
    powers += more.powers[c];
    average_in(more.noise[c],
               static_cast<double>(more.powers[c].hits) /
                   static_cast<double>(powers.hits),
               average.noise[c]);
  }
}

void add_hits(const HitBlocks& blocks,
              const Spectra& spectra,
              RunAverage& average) {
  RunAverage more;
  more.noise = line_noise(average.s, blocks);
  for (const Eigen::MatrixXcd& response : spectra.responses) {
    more.powers.push_back(cross_powers(spectra.force, response));
  }
  add_hits(more, average);
}

std::vector<Frf> average_frfs(const RunAverage& average,
                              const acquisition::TestBundle& bundle,
                              std::size_t run,
                              Estimator estimator) {
  std::vector<Frf> result;
  if (average.hits() == 0) return result;
  const acquisition::Run& of = bundle.runs[run];
  for (std::size_t c = 0; c < of.sensors.size(); ++c) {
    const CrossPowers& powers = average.powers[c];
    Estimate found = estimate(powers, estimator);
    const std::size_t channel = of.sensors[c].channel;
    const Eigen::VectorXcd factor =
        to_acceleration(average.s, bundle.channels[channel].quantity);
    Frf frf;
    frf.response = of.sensors[c].dof;
    frf.reference = of.hammer.dof;
    frf.run = run;
    frf.channel = channel;
    frf.hits = static_cast<int>(powers.hits);
    frf.variance = frf_variance(average.s, powers, found.H, average.noise[c])
                       .cwiseProduct(factor.cwiseAbs2());
    frf.variance_freedom = variance_freedom(frf.hits);
    frf.H = found.H.cwiseProduct(factor);
    frf.coherence = std::move(found.coherence);
    result.push_back(std::move(frf));
  }
  return result;
}

}  // namespace tapfit::signal
