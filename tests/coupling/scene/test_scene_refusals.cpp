// Every refusal of a scene is one line that says where, what, and what is allowed.
#include <gmock/gmock.h>

#include "coupling/scene/scene.hpp"
#include "tests/coupling/refusal.hpp"
#include "tests/coupling/scene/scene_texts.hpp"

namespace clogflow {
namespace {

using testing::HasSubstr;
using testing::Not;

std::string refused(const std::string& text, const Overrides& overrides = {}) {
  const std::string message = refusal([&] { parse_scene(text, "scenes/x.toml", overrides); });
  EXPECT_THAT(message, Not(HasSubstr("\n")));
  return message;
}

std::string with(const std::string& from, const std::string& to) {
  std::string text = channel;
  return text.replace(text.find(from), from.size(), to);
}

TEST(SceneRefusals, NameFileAndLine) {
  EXPECT_EQ(refused(with("restitution = 0.7", "restitution = 1.3")),
            "scenes/x.toml:15: contact.restitution = 1.3 (must be in [0.001, 1])");
  EXPECT_EQ(refused(with("restitution", "resitution")),
            "scenes/x.toml:15: contact.resitution = 0.7 (unknown key; the nearest known key is "
            "contact.restitution)");
  EXPECT_EQ(refused(with("diameter = \"33 um\"", "diameter = 33")),
            "scenes/x.toml:11: particles.diameter = 33 (a length needs a unit, e.g. \"33 um\")");
  EXPECT_EQ(refused(with("diameter = \"33 um\"", "diameter = \"33\"")),
            "scenes/x.toml:11: particles.diameter = \"33\" (a length needs a unit, e.g. \"33 um\")");
  EXPECT_EQ(refused(with("33 um", "33 us")),
            "scenes/x.toml:11: particles.diameter = \"33 us\" (a time, but a length is needed, "
            "e.g. \"33 um\")");
  EXPECT_EQ(refused(with("33 um", "-33 um")), "scenes/x.toml:11: particles.diameter = \"-33 um\" (must be > 0)");
}

struct Case {
  const char* override;
  const char* reason;
};

TEST(SceneRefusals, OfSingleValues) {
  const Case cases[] = {
      {"contact.restitution=1e-300", "(must be in [0.001, 1])"},
      {"contact.restitution=1.3", "--set contact.restitution=1.3: contact.restitution = 1.3 (must be in [0.001, 1])"},
      {"contact.restitution=\"0.6\"", "(must be a pure number, written without quotes"},
      {"contact.restitution=nan", "(must be a finite number)"},
      {"contact.restitution=true", "(must be a pure number"},
      {"time.end=inf", "(a time needs a unit, e.g. \"10 ms\")"},
      {"time.end=nan s", "(must be a number and a unit"},
      {"time.end=true", "(must be a time, e.g. \"10 ms\")"},
      {"time.end=60 deg", "(an angle, but a time is needed"},
      {"particles.diameter=3 foo", "unknown unit \"foo\""},
      {"geometry.half_angle=60", "(an angle needs a unit, e.g. \"60 deg\")"},
      {"geometry.half_angle=60 um", "(a length, but an angle is needed, e.g. \"60 deg\")"},
      {"geometry.half_angle=91 deg", "(must be in (0 deg, 90 deg])"},
      {"inlet.start=ful", "inlet.start = \"ful\" (must be \"filled\", \"empty\" or \"flowing\")"},
      {"flow.source=foam", "(must be \"openfoam\", \"uniform\" or \"none\")"},
      {"drag.enabled=1", "(must be true or false)"},
      {"gravity=9.81 m/s2", "(must be three values in brackets, each an acceleration"},
      {"porosity.strips=3.5", "(must be a whole number, e.g. 3)"},
      {"porosity.strips=-1", "(must be in [0, 1000])"},
      {"flow.mesh_cells_per_neck=1", "(must be in [4, 400])"},
      {"contact.poisson_ratio=0.5", "(must be in [0, 0.5))"},
      {"particles.initial=3", "(must be a text in quotes)"},
      {"ensemble.sweep=a", "ensemble.sweep = \"a\" (must be texts in quotes: [\"one\", \"two\"])"},
      {"ensemble.sweep=[1]", "ensemble.sweep = [1] (must be texts in quotes: [\"one\", \"two\"])"},
      {"ensemble.seeds=4-1", "ensemble.seeds = \"4-1\" (the range 4-1 runs backwards)"},
      {"ensemble.seeds=-3", "must be whole numbers"},
      {"ensemble.seeds=[1, 2.5]", "(must be whole numbers, e.g. [1, 2, 3]"},
      {"ensemble.seeds=true", "(must be whole numbers, e.g. [1, 2, 3]"},
      {"body_force=1 nN", "(must be three values in brackets, each a force"},
      {"body_force=[\"1 nN\", \"2 nN\"]", "(must be three values in brackets"},
      {"body_force=[\"1 nN\", 2, \"3 nN\"]", "body_force[1] = 2 (a force needs a unit"},
      {"contact=3", "contact = 3 (a section: write [contact] on a line of its own)"},
      {"friction.sliding=1", "(unknown key; the nearest known key is contact.friction.sliding)"},
      {"particles=x", "(a section"},
      {"weather=9.81", "weather = 9.81 (unknown key)"},
      {"fluid.visc=1", "(unknown key)"},
      {"fluid.viscosity=1,8 mPa s", "(a decimal comma: write a point, \"1.8 mPa s\")"},
      {"fluid.viscosity=1.8 mPas", "(unknown unit \"mPas\": write a space between two units, \"mPa s\")"},
      {"contact.restitution=0,7", "(must be a pure number, with a decimal point and no comma, e.g. 0.6)"},
      {"foo", "--set foo (write key=value"},
      {"=3", "--set =3 (write key=value"},
  };
  for (const auto& [override, reason] : cases) EXPECT_THAT(refused(channel, {override}), HasSubstr(reason));
}

TEST(SceneRefusals, OfValuesThatDisagree) {
  const Case cases[] = {
      {"geometry.neck_width=1 mm", "geometry.neck_width = \"1 mm\" (must not be wider than geometry.channel_width"},
      {"particles.diameter=100 um", "(must be smaller than geometry.neck_width = 100 um, or no particle fits through)"},
      {"geometry.neck_height=20 um", "(must be smaller than geometry.neck_height"},
      {"particles.roughness=10 um", "(must be smaller than a quarter of particles.diameter"},
      {"lubrication.cutoff=0.1 um", "(must be larger than 2 particles.roughness"},
      {"flow.velocity=1 m/s", "(is only for flow.source = \"uniform\")"},
      {"flow.grid_spacing=50 um", "(must be at most a quarter of geometry.neck_width"},
      {"flow.pulsation.strength=1", "(needs flow.pulsation.time"},
      {"drag.fluctuation.strength=1", "(needs drag.fluctuation.time"},
      {"flow.rate=0 m3/s", "(must be > 0)"},
      {"flow.rate=1 mm/s", "(a velocity, but a flow rate is needed, e.g. \"10 uL/min\")"},
      {"flow.compliance=1 m3", "(a quantity in m3, but a compliance is needed, e.g. \"1e-15 m3/Pa\")"},
      {"flow.pressure_drop=1 Pa", "flow.pressure_drop = \"1 Pa\" (is only for flow.drive = \"pressure\")"},
      {"flow.drive=pressure", "flow.pressure_drop is missing (a pressure, e.g. \"100 Pa\""},
      {"flow.drive=syringe", "(must be \"rate\" or \"pressure\")"},
      {"flow.compliance=1e-15 m3/Pa", "flow.compliance = \"1e-15 m3/Pa\" (a pressure balance keeps the mixture's rate"},
      {"flow.oscillation.amplitude=0.5", "flow.oscillation.amplitude = 0.5 (needs flow.oscillation.frequency"},
      {"flow.oscillation.amplitude=0", "(must be > 0)"},
      {"flow.oscillation.phase=1", "(must be in (0, 1))"},
      {"flow.oscillation.frequency=5 Hz", "flow.oscillation.frequency = \"5 Hz\" (needs flow.oscillation.amplitude"},
      {"flow.oscillation.shape=square", "flow.oscillation.shape = \"square\" (needs flow.oscillation.amplitude"},
      {"flow.oscillation.shape=saw", "(must be \"sine\" or \"square\")"},
      {"time.step=2 s", "(must not exceed time.end"},
      {"output.burst_snapshots=0 s", "(must be > 0)"},
  };
  for (const auto& [override, reason] : cases) {
    // The neck that outgrows its channel keeps the channel's width.
    const Overrides overrides = {"geometry.channel_width=400 um", override};
    EXPECT_THAT(refused(channel, overrides), HasSubstr(reason));
  }
}

TEST(SceneRefusals, OfShapesThatAreImpossible) {
  const std::pair<Overrides, const char*> cases[] = {
      {{"geometry.neck_rounding=1 mm"}, "geometry.neck_rounding = 1 mm (the arc does not fit"},
      {{"geometry.channel_width=100 um", "geometry.neck_rounding=10 um"}, "there is no narrowing"},
      {{"geometry.step_width=50 um", "geometry.step_length=1 mm"}, "must lie between neck_width"},
      {{"geometry.step_width=200 um"}, "needs geometry.step_length too"},
      {{"geometry.step_length=200 um"}, "needs geometry.step_width too"},
      {{"geometry.step_width=200 um", "geometry.step_length=1 mm", "geometry.half_angle_below=30 deg"},
       "leave out half_angle_below"},
      {{"geometry.expansion_width=90 um"}, "must exceed neck_width"},
      {{"geometry.expansion_length=90 um"}, "(needs geometry.expansion_width too)"},
      {{"geometry.expansion_angle=90 deg"}, "(needs geometry.expansion_width too)"},
  };
  for (const auto& [overrides, reason] : cases) EXPECT_THAT(refused(channel, overrides), HasSubstr(reason));
}

TEST(SceneRefusals, OfKeysWithoutTheirProtocol) {
  const std::pair<Overrides, std::string> cases[] = {
      {{"inlet.start=filled", "inlet.strain=3"}, "inlet.strain = 3 (is only for inlet.start = \"flowing\")"},
      {{"inlet.start=filled", "inlet.concentration=0.02"},
       "inlet.concentration = 0.02 (is for inlet.start = \"empty\": other starts are dense)"},
      {{"inlet.start=empty", "inlet.concentration=0.02", "inlet.rate=3 1/s"},
       "inlet.concentration = 0.02 (says how many come in, as inlet.rate does): leave one out"},
      {{"inlet.start=empty", "inlet.concentration=0.4"}, "inlet.concentration = 0.4 (must be in [0, 0.3])"},
      {{"unclog.protocol=rewind"},
       "unclog.protocol = \"rewind\" (needs inlet.start = \"flowing\": friction must have begun in a flow)"},
      {{"unclog.protocol=release", "unclog.strain=3"},
       "unclog.strain = 3 (is only for unclog.protocol = \"restart\" or \"rewind\")"},
      {{"unclog.protocol=stop", "unclog.region=1"},
       "unclog.region = 1 (is only for unclog.protocol = \"release\", \"restart\" or \"rewind\")"},
      {{"unclog.protocol=stop", "flow.pulsation.strength=0.1", "flow.pulsation.time=1 ms"},
       "unclog.protocol = \"stop\" (no clog is permanent under drag.fluctuation or flow.pulsation"},
  };
  for (const auto& [overrides, reason] : cases) EXPECT_THAT(refused(channel, overrides), HasSubstr(reason));
}

TEST(SceneRefusals, OfDrivesThatDisagree) {
  const auto with_drive = [](const Overrides& more) {
    Overrides all = {"flow.drive=pressure", "flow.pressure_drop=100 Pa", "drag.velocity=mixture"};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  EXPECT_NO_THROW(parse_scene(channel, "scenes/x.toml", with_drive({})));
  const std::pair<Overrides, const char*> cases[] = {
      {{"flow.compliance=1e-15 m3/Pa"}, "(lies behind a pump of constant rate"},
      {{"flow.pressure_drop=0 Pa"}, "(must be > 0)"},
      {{"drag.velocity=interstitial"}, "flow.drive = \"pressure\" (a pressure balance keeps the mixture's rate"},
      {{"drag.enabled=false"}, "(a pressure balance keeps the mixture's rate"},
      {{"drag.law=beetstra"}, "set drag.law = \"hoef\""},
      {{"drag.fluctuation.strength=1", "drag.fluctuation.time=1 ms"}, "leave out drag.fluctuation"},
      {{"time.integrator=implicit_fluid"}, "set time.integrator = \"implicit_drag\""},
      {{"flow.source=uniform"}, "(needs flow.source = \"openfoam\", whose channel resists)"},
  };
  for (const auto& [overrides, reason] : cases) EXPECT_THAT(refused(channel, with_drive(overrides)), HasSubstr(reason));
  EXPECT_THAT(refused(channel, {"flow.rate=10 uL/min", "flow.mean_velocity=5 mm/s"}),
              HasSubstr("flow.rate = \"10 uL/min\" (flow.mean_velocity is given too: choose one)"));
  EXPECT_THAT(refused(with("mean_velocity = \"5 mm/s\"", "mean_velocity = \"5 mm/s\"\nrate = \"10 uL/min\"")),
              HasSubstr("scenes/x.toml:10: flow.rate = \"10 uL/min\" (flow.mean_velocity is given too"));
  EXPECT_THAT(refused(laboratory, {"flow.rate=1 mL/h"}),
              HasSubstr("flow.rate = \"1 mL/h\" (needs a [geometry] with neck_width"));
}

TEST(SceneRefusals, OfPorositiesThatDisagree) {
  EXPECT_THAT(refused(channel, {"porosity.width=50 um"}),
              HasSubstr("porosity.width = \"50 um\" (is only for porosity.method = \"local\")"));
  EXPECT_THAT(refused(channel, {"porosity.method=local", "porosity.width=16 um"}),
              HasSubstr("(must be at least half of particles.diameter = 33 um"));
  for (const char* other : {"porosity.method=local", "porosity.strips=0"})
    EXPECT_THAT(refused(channel, {"porosity.neck=true", other}), HasSubstr("porosity.neck = true (is one more strip"));
  EXPECT_THAT(refused(channel, {"porosity.method=mean"}), HasSubstr("\"strips\""));
  EXPECT_THAT(refused(laboratory, {"porosity.method=local", "porosity.strips=0"}),
              HasSubstr("porosity.method = \"local\" (needs a [geometry] with neck_width)"));
}

TEST(SceneRefusals, OfALaboratoryThatDisagrees) {
  EXPECT_THAT(refused(laboratory, {"flow.source=openfoam"}), HasSubstr("(openfoam needs a [geometry] section)"));
  EXPECT_THAT(refused(laboratory, {"inlet.enabled=true"}), HasSubstr("(an inlet needs a [geometry] with neck_width)"));
  EXPECT_THAT(refused(laboratory, {"porosity.strips=3"}), HasSubstr("(strips need a [geometry]"));
  EXPECT_THAT(refused(laboratory, {"unclog.protocol=release", "unclog.after=1 ms"}),
              HasSubstr("(needs a [geometry] with neck_width)"));
  EXPECT_THAT(refused(laboratory, {"unclog.protocol=release"}), HasSubstr("unclog.after is missing"));
  EXPECT_THAT(refused(laboratory, {"drag.enabled=true"}),
              HasSubstr("fluid.viscosity is missing (a viscosity, e.g. \"1.8 mPa s\"; drag is on)"));
  EXPECT_THAT(refused(laboratory, {"lubrication.enabled=true"}), HasSubstr("fluid.viscosity is missing"));
  EXPECT_THAT(refused(laboratory, {"flow.source=uniform"}), HasSubstr("flow.velocity is missing"));
  EXPECT_THAT(refused(laboratory, {"flow.rescale=true"}), HasSubstr("(is only for flow.source = \"openfoam\")"));
  EXPECT_THAT(refused(laboratory, {"flow.extrapolate=true"}), HasSubstr("(is only for flow.source = \"openfoam\")"));
  EXPECT_THAT(refused(laboratory, {"flow.oscillation.amplitude=1", "flow.oscillation.frequency=1 Hz"}),
              HasSubstr("(there is no flow to oscillate)"));
  EXPECT_THAT(refused(channel, {"flow.oscillation.amplitude=1", "flow.oscillation.frequency=1 Hz",
                                "flow.oscillation.table=ramp.csv"}),
              HasSubstr("flow.oscillation.table = \"ramp.csv\" (stands in the place of flow.oscillation.amplitude"));
  EXPECT_THAT(refused(laboratory, {"flow.pulsation.strength=1", "flow.pulsation.time=1 s"}),
              HasSubstr("(there is no flow to pulsate)"));
  EXPECT_THAT(refused(laboratory, {"drag.fluctuation.strength=1", "drag.fluctuation.time=1 s", "drag.enabled=false"}),
              HasSubstr("(needs drag)"));
  const std::string min = R"(box.min=["0 m","0 m","0 m"])";
  EXPECT_THAT(refused(laboratory, {min}), HasSubstr("box.max is missing"));
  EXPECT_THAT(refused(laboratory, {min, R"(box.max=["1 m","1 m","0 m"])"}),
              HasSubstr("(must be larger than box.min in each component)"));
  EXPECT_THAT(refused(laboratory, {min, R"(box.max=["1 m","1 m","9 um"])"}),
              HasSubstr("(must be smaller than the box along z"));
  EXPECT_THAT(refused(channel, {min, R"(box.max=["1 m","1 m","1 m"])"}), HasSubstr("(each gives walls: choose one)"));
  EXPECT_THAT(refused(channel, {"flow.source=none"}), HasSubstr("(nothing carries particles away from it"));
  EXPECT_THAT(
      refused(channel,
              {"flow.source=none", "inlet.enabled=false", "unclog.protocol=none", "output.burst_snapshots=1 ms"}),
      HasSubstr("output.burst_snapshots = \"1 ms\" (needs a flow, or gravity along +x in its place: a burst is over "
                "when nothing has passed for d / v)"));
  // What falls along the channel, and what does not.
  const Overrides none = {"flow.source=none", "unclog.after=1 ms"};
  const auto under = [&](const char* gravity) {
    Overrides all = none;
    all.push_back(gravity);
    return all;
  };
  EXPECT_THAT(refused(channel, under(R"(gravity=["-9.81 m/s2", "0 m/s2", "0 m/s2"])")),
              HasSubstr("a flow must fill the channel, or gravity along +x in its place: set flow.source or gravity"));
  Overrides falling = under(R"(gravity=["9.81 m/s2", "0 m/s2", "0 m/s2"])");
  EXPECT_THAT(refused(channel, falling), HasSubstr("a flow must fill the channel"));  // as heavy as its fluid
  falling.push_back("particles.density=2000 kg/m3");
  EXPECT_NO_THROW(parse_scene(channel, "x", falling));
  EXPECT_THAT(refused(channel, {"contact.wall_restitution=0"}), HasSubstr("contact.wall_restitution"));
  EXPECT_THAT(refused(channel, {"contact.wall_restitution=1.5"}), HasSubstr("contact.wall_restitution"));
}

TEST(SceneRefusals, OfWhatIsMissing) {
  EXPECT_THAT(refused(""), HasSubstr("scenes/x.toml: particles.diameter is missing (a length, e.g. \"33 um\")"));
  const auto without = [](const std::string& line) { return with(line + "\n", ""); };
  EXPECT_THAT(refused(without("neck_width = \"100 um\"")), HasSubstr("geometry.neck_width is missing"));
  EXPECT_THAT(refused(without("half_angle = \"60 deg\"")),
              HasSubstr("geometry.half_angle is missing (an angle, e.g. \"60 deg\")"));
  EXPECT_THAT(refused(without("mean_velocity = \"5 mm/s\"")),
              HasSubstr("flow.mean_velocity is missing (a velocity, e.g. \"5 mm/s\"; flow.source is openfoam)"));
  EXPECT_THAT(refused(without("youngs_modulus = \"3 MPa\"")), HasSubstr("contact.youngs_modulus is missing"));
  EXPECT_THAT(refused(without("poisson_ratio = 0.35")),
              HasSubstr("contact.poisson_ratio is missing (a pure number, e.g. 0.3)"));
  EXPECT_THAT(refused(without("end = \"1 s\"")), HasSubstr("time.end is missing"));
  EXPECT_THAT(refused("[particles]\ndiameter = \"1 mm\"\n"), HasSubstr("there is no fluid.density to take it from"));
}

TEST(SceneRefusals, OfTextThatIsNoScene) {
  EXPECT_THAT(refused("[particles\ndiameter"), HasSubstr("scenes/x.toml:1: "));
  EXPECT_THAT(refused("a = 1\na = 2\n"), HasSubstr("scenes/x.toml:2: "));
  EXPECT_THAT(refused(channel + "\n[nonsense]\n"), HasSubstr("nonsense = {...} (unknown key"));
  EXPECT_THAT(refused(channel + "step = \"1 us\"\nstep_fraction = 0.1\n"),
              HasSubstr("time.step_fraction = 0.1 (time.step is given too: choose one)"));
  EXPECT_THAT(refused("contact = 3\n"), HasSubstr("scenes/x.toml:1: contact = 3 (a section"));
  EXPECT_THAT(refused(std::string("\0\1\2\xff", 4)), HasSubstr("scenes/x.toml:1: "));
  EXPECT_THAT(refused(fmt::format("x = \"{}\"", std::string(100000, 'a'))), testing::SizeIs(testing::Lt(250)));
  EXPECT_THAT(refusal([] { read_scene("nowhere.toml"); }), HasSubstr("nowhere.toml (no such scene file)"));
  EXPECT_THAT(refusal([] { read_scene("/"); }), HasSubstr("cannot be read"));
}

}  // namespace
}  // namespace clogflow
