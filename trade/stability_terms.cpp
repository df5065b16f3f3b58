#include "trade/stability_terms.hpp"

#include <cmath>
#include <filesystem>

#include <fmt/format.h>
#include <unistd.h>

#include "coupling/base/publish_file.hpp"
#include "coupling/base/require.hpp"
#include "trade/spread.hpp"
#include "trade/term_columns.hpp"

namespace clogflow {

namespace {

/// A table of one factor on the flow in a file of its own, gone with it.
class LoadTable {
public:
  explicit LoadTable(const TermPoint& p)
      : file_(std::filesystem::temp_directory_path() /
              fmt::format("clogflow_load_{}_{}_{}.csv", getpid(), name(p.term), p.base.number)) {}
  ~LoadTable() {
    std::error_code ignored;
    std::filesystem::remove(file_, ignored);
  }
  LoadTable(const LoadTable&) = delete;
  LoadTable& operator=(const LoadTable&) = delete;

  // Never through a link that lies under this name.
  void set(double factor) const { publish_file(fmt::format("time,factor\n0,{}\n", factor), file_); }
  std::string path() const { return file_.string(); }

private:
  std::filesystem::path file_;
};

/// A driven column bears the mean flow, the least and the largest, one after the other, and is measured under the
/// largest: a drive takes thousands of steps to change, so that each load finds a pack at rest.
class TermColumn : public Column {
public:
  TermColumn(const TermPoint& point, double overlap)
      : point_(point),
        scene_(term_scene(point)),
        flow_(term_flow(scene_)),
        particles_(term_particles(point, overlap)),
        table_(point) {
    table_.set(1);
  }

  double diameter() const override { return point_.base.diameter; }

  Simulation simulation(double step) const override {
    Scene scene = with_step(step);
    if (is_driven()) scene.flow.oscillation.table = table_.path();
    return Simulation(scene, flow_.get(), 1, particles_);
  }

  Simulation loose(double step) const override {
    Scene scene = with_step(step);
    if (is_driven()) add_drive(scene);
    return Simulation(scene, flow_.get(), 1, particles_);
  }

  /// Springs that stick hold less than nothing when they are drawn: there the work of the load and of adhesion.
  double scale(const Simulation& simulation) const override {
    if (point_.stickiness == 0) return simulation.elastic_energy();
    const double radius = point_.base.diameter / (2 * (1 + point_.size_ratio));
    const double load = drag_of_one(point_.base, scene_) * (1 + point_.stickiness);
    return load * std::abs(simulation.model().laws.pair.overlap_at(load, radius)) *
           static_cast<double>(particles_.size());
  }

  int loads() const override { return is_driven() ? 3 : 1; }
  void load(int k) const override {
    const double factors[] = {1, 1 - point_.amplitude, 1 + point_.amplitude};
    if (is_driven()) table_.set(factors[k]);
  }

  /// The scene as a run would have it.
  Scene run_scene() const {
    Scene scene = scene_;
    if (is_driven()) add_drive(scene);
    return scene;
  }
  const FlowGrid* flow() const { return flow_.get(); }
  const std::vector<Particle>& particles() const { return particles_; }
  void know(double step, double expected) { step_ = step, longest_ = expected; }

  double longest_on_the_way() const override { return longest_; }

private:
  bool is_driven() const { return point_.amplitude > 0; }

  Scene with_step(double step) const {
    Scene scene = scene_;
    scene.time.step = step;
    scene.time.end = trial_steps * step;
    return scene;
  }

  void add_drive(Scene& scene) const {
    const double period = trial_steps * (step_ > 0 ? step_ : 1) / point_.periods;
    if (point_.shape == "random") {
      scene.flow.pulsation.strength = point_.amplitude, scene.flow.pulsation.time = period;
      return;
    }
    scene.flow.oscillation.amplitude = point_.amplitude;
    scene.flow.oscillation.shape = point_.shape == "square" ? OscillationShape::square : OscillationShape::sine;
    scene.flow.oscillation.frequency = 1 / period;
  }

  const TermPoint& point_;
  Scene scene_;
  std::shared_ptr<FlowGrid> flow_;
  std::vector<Particle> particles_;
  LoadTable table_;
  double step_ = 0, longest_ = 0;  // the point's own, and for contacts that are about to be pressed [s]
};

}  // namespace

std::string name(Term term) {
  constexpr const char* names[term_count] = {"sizes", "densities", "frictions",  "jkr",     "dmt",
                                             "hooke", "mercury",   "beetstra",   "gravity", "drive",
                                             "local", "pressure",  "compliance", "walls",   "together"};
  return names[static_cast<int>(term)];
}

TermPoint term_point(Term term, int number) {
  // Numbers that no point of the first family has, and no other term.
  const int k = 1000 * (1 + static_cast<int>(term)) + number;
  const auto u = [&](int prime) { return root_spread(k, prime); };
  constexpr const char* shapes[] = {"sine", "square", "random"};
  TermPoint p{.term = term, .base = extreme_point(k)};
  const auto is = [&](Term one) { return term == one || term == Term::together; };
  const int law = term == Term::together ? k % 4
                  : term == Term::jkr    ? 1
                  : term == Term::dmt    ? 2
                  : term == Term::hooke  ? 3
                                         : 0;
  if (is(Term::sizes)) p.size_ratio = log_between(u(29), 1, 10);
  if (is(Term::densities)) p.density_ratio = log_between(u(31), 0.1, 10);
  // A third of them smooth altogether.
  if (is(Term::frictions)) p.friction_share = k % 3 == 0 ? 0 : u(37);
  p.law = law == 1 ? "jkr" : law == 2 ? "dmt" : law == 3 ? "hooke" : "hertz";
  if (law == 1 || law == 2) p.stickiness = log_between(u(41), 0.01, 100);
  if (law == 3) p.spring = log_between(u(43), 1e-3, 1);
  // Other laws know no other turning.
  p.mercury = term == Term::mercury || (term == Term::together && k % 5 < 2 && p.law == "hertz");
  if (term == Term::beetstra || (term == Term::together && k % 3 == 0)) p.drag = "beetstra";
  if (is(Term::gravity)) p.weight = log_between(u(47), 0.01, 100);
  if (is(Term::drive)) p.amplitude = log_between(u(53), 0.1, 2), p.shape = shapes[k % 3];
  if (is(Term::drive)) p.periods = 1 + static_cast<int>(20 * u(59));
  // Films and a balance of pressures are not solved for together.
  if ((term == Term::pressure || term == Term::compliance) && p.base.integrator == Integrator::implicit_fluid)
    p.base.integrator = Integrator::implicit_drag;
  if (term == Term::pressure) p.drop_ratio = log_between(u(61), 1, 100);
  if (term == Term::compliance) p.compliance_steps = log_between(u(67), 10, 1e4);
  if (term == Term::walls) p.wall_ratio = log_between(u(71), 0.01, 100);
  return p;
}

StepVerdict measure(const TermPoint& point) {
  StepVerdict result;
  try {
    TermColumn loose(point, 0);
    const Model model = make_model(loose.run_scene(), loose.flow(), {});
    const StepLimits limits = expected_limits(model, {});
    result.step = model.contact_time * point.base.step_fraction;
    result.expected = limits.smallest();
    require(limits.expected_overlap <= deepest_overlap, "overlaps of {:.2g} diameters are to be expected",
            limits.expected_overlap);
    // Close to rest: the lowest layer's share of the load that the limit expects.
    const double layers = std::ceil(point.base.particles / 9.0);
    TermColumn column(point, limits.expected_overlap * std::pow(layers / 20, 2.0 / 3));
    column.know(result.step, result.expected);
    try_steps(column, result);
  } catch (const std::exception& error) {
    result.reason = error.what();
  }
  return result;
}

}  // namespace clogflow
