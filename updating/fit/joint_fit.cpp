#include "updating/fit/joint_fit.hpp"

#include "acquisition/foundation/input_error.hpp"
#include "acquisition/foundation/parallel.hpp"
#include "signal/statistics/tail_probability.hpp"
#include "updating/fit/fitted_form.hpp"
#include "updating/fit/overall_progress.hpp"
#include "updating/frf_model/mesh_at_state.hpp"
#include "updating/minimiser/minimise.hpp"
#include "updating/residual/independent_data.hpp"
#include "updating/residual/parameter_uncertainty.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tapfit::updating {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::VectorXd;

namespace {

constexpr MinimiseOptions exact{30, 1e-6, 1e-3};
constexpr int rounds = 5;
// Of a parameter's standard deviation.
constexpr double settled_step = 0.05;

class Together {
 public:
  explicit Together(std::vector<JointTest> tests);

  // The misfit of all made least with weights and meshes as they are now.
  void go_on(const Progress& progress);
  // How far that moved what is most certain, in standard deviations.
  [[nodiscard]] double moved() const;
  [[nodiscard]] JointFit finished() &&;

 private:
  // A test among the others.
  struct Part {
    JointTest test;
    std::vector<Index> at;  // in theta, of each of its parameters
    Prior prior;            // of its own theta
    double data = 1.0;      // N
    double weight = 1.0;    // sqrt(N) / ||r||
    Residuals left;         // at theta, not weighted

    [[nodiscard]] ModelState state(const VectorXd& theta) const {
      VectorXd own = test.offset;
      for (Index k = 0; k < own.size(); ++k) {
        own(k) += theta(at[static_cast<std::size_t>(k)]);
      }
      return unpack(test.alone.result.state, own);
    }
    [[nodiscard]] const Target& target() const { return test.fitter->target(); }
  };

  [[nodiscard]] Residuals known(const VectorXd& theta) const;
  void take_prior(const Part& part);
  [[nodiscard]] VectorXd start() const;
  void take_mesh(Part& part) const;
  [[nodiscard]] std::optional<Residuals> left(const Part& part,
                                              const VectorXd& theta) const;
  [[nodiscard]] std::optional<Residuals> evaluate(const VectorXd& theta) const;
  // By how much it leaves.
  static void weigh(Part& part, const VectorXd& r);
  // d r of a part / d theta, zero where it does not depend on it.
  [[nodiscard]] MatrixXd among_all(const Part& part) const;
  [[nodiscard]] MatrixXd covariance(const std::vector<Target>& targets) const;

  std::vector<Part> parts_;
  VectorXd theta_;
  VectorXd before_;  // theta before the last go_on()
  Prior prior_;
  bool converged_ = false;
  std::string message_;
};

Together::Together(std::vector<JointTest> tests) {
  Index count = 0;
  for (const JointTest& test : tests) {
    for (const auto& number : test.shared) {
      if (number) count = std::max(count, static_cast<Index>(*number) + 1);
    }
  }
  for (JointTest& test : tests) {
    Part part;
    part.prior =
        test.fitter->prior_for(*test.alone.model, test.alone.result.state);
    for (const auto& number : test.shared) {
      part.at.push_back(number ? static_cast<Index>(*number) : count++);
    }
    part.test = std::move(test);
    parts_.push_back(std::move(part));
  }
  prior_ = {VectorXd::Zero(count),
            VectorXd::Zero(count),
            VectorXd::Zero(count),
            VectorXd::Zero(count)};
  // The first that has it is taken last.
  for (auto part = parts_.rbegin(); part != parts_.rend(); ++part) {
    take_prior(*part);
  }
  prior_.known = [this](const VectorXd& theta) { return known(theta); };
  theta_ = start();
  for (Part& part : parts_) weigh(part, part.test.alone.result.residual);
}

void Together::take_prior(const Part& part) {
  const VectorXd& offset = part.test.offset;
  for (Index k = 0; k < offset.size(); ++k) {
    const Index at = part.at[static_cast<std::size_t>(k)];
    prior_.mean(at) = part.prior.mean(k) - offset(k);
    prior_.sd(at) = part.prior.sd(k);
    prior_.lower(at) = part.prior.lower(k) - offset(k);
    prior_.upper(at) = part.prior.upper(k) - offset(k);
  }
}

// What is known besides of each test's structure.
Residuals Together::known(const VectorXd& theta) const {
  Residuals all{VectorXd(0), MatrixXd(0, theta.size())};
  for (const Part& part : parts_) {
    if (!part.prior.known) continue;
    const Residuals own = part.prior.known(theta(part.at) + part.test.offset);
    const Index rows = all.r.size() + own.r.size();
    all.r.conservativeResize(rows);
    all.r.tail(own.r.size()) = own.r;
    all.J.conservativeResize(rows, Eigen::NoChange);
    all.J.bottomRows(own.r.size()).setZero();
    all.J.bottomRows(own.r.size())(Eigen::all, part.at) = own.J;
  }
  return all;
}

// Between what the tests say by themselves.
VectorXd Together::start() const {
  VectorXd sum = VectorXd::Zero(prior_.mean.size());
  VectorXd weight = VectorXd::Zero(sum.size());
  for (const Part& part : parts_) {
    const UpdateResult& alone = part.test.alone.result;
    const VectorXd theta = pack(alone.state) - part.test.offset;
    for (Index k = 0; k < theta.size(); ++k) {
      const Index at = part.at[static_cast<std::size_t>(k)];
      const double own = 1.0 / std::max(alone.covariance(k, k), 1e-12);
      sum(at) += own * theta(k);
      weight(at) += own;
    }
  }
  return sum.cwiseQuotient(weight);
}

// What the mesh does to the modes as they have become.
void Together::take_mesh(Part& part) const {
  Fit& fit = part.test.alone;
  const FitProblem& problem = part.test.fitter->problem();
  if (fit.model->coarser() == nullptr || problem.corrections.empty()) return;
  const std::size_t first =
      problem.uncertain_sd.size() - problem.corrections.size();
  fit.model = with_mesh_at(
      *fit.model, *fit.model->coarser(), part.state(theta_), first);
}

std::optional<Residuals> Together::left(const Part& part,
                                        const VectorXd& theta) const {
  const Target& target = part.target();
  const ModelResponse response =
      part.test.alone.model->respond(part.state(theta), target.s, true);
  if (!response.H.allFinite()) return std::nullopt;
  Residuals at{residual(target, response.H), {}};
  at.J.resize(at.r.size(), std::ssize(response.dH));
  for (std::size_t k = 0; k < response.dH.size(); ++k) {
    at.J.col(static_cast<Index>(k)) = stack(target, response.dH[k]);
  }
  return at;
}

MatrixXd Together::among_all(const Part& part) const {
  MatrixXd J = MatrixXd::Zero(part.left.J.rows(), theta_.size());
  for (Index k = 0; k < part.left.J.cols(); ++k) {
    J.col(part.at[static_cast<std::size_t>(k)]) = part.left.J.col(k);
  }
  return J;
}

std::optional<Residuals> Together::evaluate(const VectorXd& theta) const {
  std::vector<std::optional<Residuals>> each(parts_.size());
  for_each_parallel(each.size(),
                    [&](std::size_t k) { each[k] = left(parts_[k], theta); });
  Index rows = 0;
  for (const auto& own : each) {
    if (!own) return std::nullopt;
    rows += own->r.size();
  }
  Residuals all{VectorXd(rows), MatrixXd::Zero(rows, theta.size())};
  Index row = 0;
  for (std::size_t k = 0; k < each.size(); ++k) {
    const Part& part = parts_[k];
    const Residuals& own = *each[k];
    all.r.segment(row, own.r.size()) = part.weight * own.r;
    for (Index p = 0; p < own.J.cols(); ++p) {
      all.J.col(part.at[static_cast<std::size_t>(p)])
          .segment(row, own.r.size()) = part.weight * own.J.col(p);
    }
    row += own.r.size();
  }
  return all;
}

void Together::weigh(Part& part, const VectorXd& r) {
  part.data = independent_data(part.target(), r);
  part.weight = std::sqrt(part.data) / std::max(r.norm(), 1e-150);
}

void Together::go_on(const Progress& progress) {
  for_each_parallel(parts_.size(),
                    [&](std::size_t k) { take_mesh(parts_[k]); });
  before_ = theta_;
  double data = 0.0;
  for (const Part& part : parts_) data += part.data;
  double steps = 0.0;
  const auto found = minimise(
      [this](const VectorXd& theta) { return evaluate(theta); },
      prior_,
      [data](const VectorXd&) { return data; },
      theta_,
      exact,
      [&](const Iterate&) {
        progress("fitting tests together", ++steps / (exact.most_steps + 1));
        return true;
      });
  if (!found) {
    throw InputError("the tests have no model together",
                     "where they are fitted at once",
                     "its FRFs are not finite: let each test have for itself "
                     "what they say differently alone");
  }
  theta_ = found->point.theta;
  converged_ = found->converged;
  message_ = found->message;
  for (Part& part : parts_) {
    part.left = *left(part, theta_);
    weigh(part, part.left.r);
  }
}

// The n-th pattern of a test is taken for the n-th of another one of the
// structure.
std::vector<int> deviations(const Target& target, int structure) {
  const Index count = target.form_bias.cols();
  const Index modes = count - common_patterns(target);
  std::vector<int> result;
  for (Index k = 0; k < count; ++k) {
    constexpr int most = 10000;  // modes of a structure
    const Index of = k < modes ? k : most - 1 - (k - modes);
    result.push_back(structure * most + static_cast<int>(of));
  }
  return result;
}

MatrixXd Together::covariance(const std::vector<Target>& targets) const {
  std::vector<MatrixXd> J;
  for (const Part& part : parts_) J.push_back(among_all(part));
  std::vector<FittedResidual> left;
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    left.push_back({targets[k],
                    J[k],
                    parts_[k].left.r,
                    parts_[k].left.J.cols(),
                    deviations(targets[k], parts_[k].test.structure)});
  }
  return parameter_covariance(left, prior_.sd, known_slopes(prior_, theta_));
}

double Together::moved() const {
  std::vector<Target> targets;
  for (const Part& part : parts_) targets.push_back(part.target());
  const VectorXd sd = covariance(targets).diagonal().cwiseSqrt();
  return (theta_ - before_).cwiseAbs().cwiseQuotient(sd).maxCoeff();
}

JointFit Together::finished() && {
  JointFit result{{}, converged_, message_};
  std::vector<Target> targets;
  for (Part& part : parts_) {
    ModelState state = part.state(theta_);
    Fit fit = std::move(part.test.alone);
    UpdateResult& own = fit.result;
    own.state = std::move(state);
    own.error = error_of(part.target(), part.left.r);
    own.residual = part.left.r;
    own.jacobian = part.left.J;
    own.prior = part.prior;
    own.history.clear();
    own.converged = converged_;
    own.message = message_;
    fit.effects = own.state.effects;
    FittedForm form = fitted_form(*fit.model,
                                  own,
                                  part.target(),
                                  part.test.fitter->problem().form_allowance);
    fit.form = std::move(form.view);
    fit.log_likelihood = form.log_likelihood;
    targets.push_back(part.target());
    targets.back().form_bias = std::move(form.bias);
    result.fits.push_back(std::move(fit));
  }
  const MatrixXd all = covariance(targets);
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    result.fits[k].result.covariance = all(parts_[k].at, parts_[k].at);
  }
  return result;
}

}  // namespace

JointFit fit_together(std::vector<JointTest> tests, const Progress& progress) {
  Together together(std::move(tests));
  for (int round = 0; round < rounds; ++round) {
    together.go_on(part_of(
        progress, static_cast<double>(round) / rounds, (round + 1.0) / rounds));
    if (together.moved() <= settled_step) break;
  }
  return std::move(together).finished();
}

Agreement agreement(const VectorXd& estimates, const VectorXd& variance) {
  const VectorXd weight = variance.cwiseInverse();
  const double mean = weight.dot(estimates) / weight.sum();
  Agreement result;
  result.q = weight.dot((estimates.array() - mean).square().matrix());
  result.degrees = static_cast<int>(estimates.size()) - 1;
  if (result.degrees > 0) {
    result.probability = signal::chi_squared_tail(result.q, result.degrees);
  }
  return result;
}

}  // namespace tapfit::updating
