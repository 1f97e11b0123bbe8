#include "analysis/cycles/cycle.hpp"
#include "apps/branches/section_point.hpp"
#include "apps/describe/describe_command.hpp"
#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"

#include <fmt/format.h>

#include <complex>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace swirl::apps::describe {

namespace {

constexpr double no_value = std::numeric_limits<double>::quiet_NaN();  // null in JSON

std::string branch_name(SteadyBranch branch) {
    return branch == SteadyBranch::plus ? "+" : "-";
}

std::string jamming_in_words(const Description& d) {
    if (!d.facts.painleve_friction) return "never: a disk's normal and tangential impulse do not couple";
    return fmt::format("from mu = {:.6g} on: {}", *d.facts.painleve_friction, d.facts.can_jam ? "here" : "not here");
}

std::string shelter_in_words(const Description& d, const std::optional<Units>& units) {
    const double radius = d.facts.untouched_radius;
    if (radius > 0)
        return fmt::format("while its centre is within {}{} of the swirl's centre", with_unit(radius, units, "R_c"),
                           units ? "" : " R_c");
    return fmt::format("nowhere: 1 - alpha - beta = {:.6g}", radius);
}

std::string fate_in_words(const Description& d) {
    if (d.facts.impacts == ImpactFate::fade) return "fade: each lowers J (mu = 0) or the energy (beta = 0)";
    if (d.facts.impacts == ImpactFate::conserved) return "last: J is conserved (mu = 0, e = 1)";
    if (keeps_energy_without_sliding(d.scene))
        return "can last: without sliding J + I S/alpha is conserved (e = e_t = 1)";
    if (d.scene.beta == 0 && d.scene.restitution == 1)
        return "can last: without slip an impact takes nothing (beta = 0, e = 1)";
    return "can last: friction and swirl may give back what they take";
}

/// The facts that every scene has.
Table<Description> fact_table(bool disk, const std::optional<Units>& units = {}) {
    using F = Field<Description>;
    const auto of = [](auto member) { return [member](const Description& d) { return d.facts.*member; }; };
    const auto widest = [disk](const Description& d) { return disk ? no_value : d.facts.widest_chi; };
    const auto shelter = [units](const Description& d) { return shelter_in_words(d, units); };
    const auto jams_from = [](const Description& d) { return d.facts.painleve_friction.value_or(no_value); };
    return {
        {},
        {F{"widest_chi", widest, "rad", "largest |chi|"}.shown("largest |chi|, chi_m", "{:.6g}"),
         {"painleve_friction", jams_from, no_column},
         {"can_jam", of(&SceneFacts::can_jam), no_column},
         F{"jamming", jamming_in_words, no_column}.table_only().shown("sliding can jam (Painleve)", "{}"),
         {"sheltered", [](const Description& d) { return d.facts.untouched_radius > 0; }, no_column},
         {"untouched_radius", of(&SceneFacts::untouched_radius), "R_c",
          "of the circle in which the body's centre is out of the wall's reach"},
         {"untouched_room_turning", of(&SceneFacts::untouched_room_turning), "R_c", "the same of a body that turns"},
         F{"shelter", shelter, no_column}.table_only().shown("sheltered from the wall", "{}"),
         {"impacts", of(&SceneFacts::impacts), no_column},
         F{"fate", fate_in_words, no_column}.table_only().shown("impacts", "{}")}};
}

std::string circulation_in_words(const RimFacts& rim) {
    if (rim.circulates_forward) return rim.circulates_backward ? "in both directions" : "forward only (psi' > 0)";
    return rim.circulates_backward ? "backward only (psi' < 0)" : "not on the slowest";
}

/// The pendulum of a disk on the wall.
Table<RimFacts> rim_table() {
    using F = Field<RimFacts>;
    const auto spin = [](const RimFacts& rim) { return rim.mean_spin.value_or(no_value); };
    const auto motion = [](const RimFacts& rim) { return rim.rolls ? "rolls" : "slides without friction"; };
    return {
        {},
        {{"rolls", &RimFacts::rolls, no_column},
         F{"motion", motion, no_column}.table_only().shown("disk on the wall (reached if e < 1)", "{}"),
         F{"strength", &RimFacts::strength, "omega_s^2", "the pendulum's k"}.shown("  pendulum's strength k", "{:.6g}"),
         F{"small_frequency", &RimFacts::small_frequency, "omega_s", "of small librations"}.shown(
             "  small librations, sqrt(k)", "{:.6g}"),
         F{"circulation_energy", &RimFacts::circulation_energy, "omega_s^2", "H above which it circulates"}.shown(
             "  circulates above H", "{:.6g}"),
         F{"rest_force", &RimFacts::rest_force, "m R_c omega_s^2", "of the wall at rest"}.shown(
             "  force of the wall at rest", "{:.6g}"),
         F{"mean_S", spin, "1", "S at rest, mean S librating"}.shown("  S at rest and mean librating", "{:.6g}"),
         F{"widest_libration", &RimFacts::widest_libration, "rad", "|psi| up to which librations stay on the wall"}
             .shown("  librations stay up to |psi|", "{:.6g}"),
         {"circulates_forward", &RimFacts::circulates_forward, no_column},
         {"circulates_backward", &RimFacts::circulates_backward, no_column},
         F{"circulates", circulation_in_words, no_column}.table_only().shown("  circulations stay", "{}")}};
}

std::vector<double> parts_of(const SteadyMode& mode, double (*part)(const std::complex<double>&)) {
    std::vector<double> values;
    for (const auto& m : mode.multipliers) values.push_back(part(m));
    return values;
}

analysis::Stability stability_of_mode(const SteadyMode& mode) {
    return analysis::stability_of(mode.multipliers);
}

}  // namespace

Table<SteadyMode> mode_table(bool disk, std::size_t d, const std::vector<SteadyMode>* numbered) {
    using F = Field<SteadyMode>;
    const auto point = [disk](const SteadyMode& m) { return coordinates_of(m.point, disk); };
    const auto list = [point](const SteadyMode& m) {
        const Eigen::VectorXd z = point(m);
        return std::vector<double>(z.begin(), z.end());
    };
    const auto re = [](const SteadyMode& m) { return parts_of(m, std::real); };
    const auto im = [](const SteadyMode& m) { return parts_of(m, std::imag); };
    const auto chi = [disk](const SteadyMode& m) { return disk ? no_value : m.chi; };
    const auto number = [numbered](const SteadyMode& m) {
        return numbered != nullptr ? &m - numbered->data() + 1 : std::ptrdiff_t{0};
    };
    return {{"steady_mode"},
            {F{"number", number, no_column}.table_only().shown("orbit", "  {:>5}").when(numbered != nullptr),
             F{"branch", [](const SteadyMode& m) { return branch_name(m.branch); }, "", "+: psi near 0; -: psi near pi"}
                 .flags({"+", "-"})
                 .shown("branch", " {:>6}"),
             F{"j", &SteadyMode::j, "1", "vertices on"}.shown("j", " {:>5}"),
             F{"tau", &SteadyMode::tau, "1/omega_s", "flight time"}.shown("tau", " {:>13.9f}"),
             F{"chi", chi, "rad", "arg r - arg n at the impact"}.shown("chi", " {:>12.9f}"),
             F{"S", [](const SteadyMode& m) { return m.point.spin; }, "1", "spin"}.shown("S", " {:>13.9f}"),
             {"speed", &SteadyMode::speed, "R_c omega_s", "u_n before the impact"},
             F{"contact_mode", &SteadyMode::contact, "", "contact mode of the impact"}
                 .flags(names_up_to(ContactMode::r_reversed))
                 .shown("contact", "  {:<12}"),
             F{"point", list, "1", "section point"}
                 .along({"coordinate"}, d)
                 .json_written([point](JsonWriter& json, const SteadyMode& m) { write_point(json, point(m)); }),
             {"multipliers", [](JsonWriter& json, const SteadyMode& m) { json.array(m.multipliers); }},
             F{"multiplier_re", re, "1", "real part"}.along({"multiplier_index"}, d).record_only(),
             F{"multiplier_im", im, "1", "imaginary part"}.along({"multiplier_index"}, d).record_only(),
             F{"largest_multiplier", [](const SteadyMode& m) { return std::abs(m.multipliers.front()); }, no_column}
                 .table_only()
                 .shown("|multiplier|", " {:>12.8g}"),
             F{"stability", stability_of_mode, "", "by the multipliers"}
                 .flags(names_up_to(analysis::Stability::neutral))
                 .shown("stability", "  {}"),
             {"residual", &SteadyMode::residual, "1", "largest |F(z) - z|"}}};
}

namespace {

/// Families over the flight time, each with the member midway.
Table<DescribedFamily> family_table(bool disk) {
    using F = Field<DescribedFamily>;
    const auto midway = [disk](JsonWriter& json, const DescribedFamily& f) {
        f.midway ? write_object(json, mode_table(disk, 0), *f.midway) : json.null();
    };
    const auto spin = [](const DescribedFamily& f) { return f.midway ? f.midway->point.spin : no_value; };
    const auto largest = [](const DescribedFamily& f) {
        return f.midway ? std::abs(f.midway->multipliers.front()) : no_value;
    };
    const auto stability = [](const DescribedFamily& f) {
        return f.midway ? std::string(analysis::name_of(stability_of_mode(*f.midway))) : "none";
    };
    std::vector<std::string> names = names_up_to(analysis::Stability::neutral);
    names.emplace_back("none");
    return {
        {"family"},
        {F{"branch", [](const DescribedFamily& f) { return branch_name(f.family.branch); }, "",
           "+: psi near 0; -: psi near pi"}
             .flags({"+", "-"})
             .shown("branch", "  {:>6}"),
         F{"j", [](const DescribedFamily& f) { return f.family.j; }, "1", "vertices on"}.shown("j", " {:>5}"),
         F{"shortest_return_time", [](const DescribedFamily& f) { return f.family.from; }, "1/omega_s",
           "flight time from which on there are members"}
             .shown("from tau", " {:>13.9f}"),
         F{"longest_return_time", [](const DescribedFamily& f) { return f.family.to; }, "1/omega_s",
           "flight time up to which there are members"}
             .shown("to tau", " {:>13.9f}"),
         {"S_is_free", [](const DescribedFamily& f) { return f.family.spin_is_free; }, "1",
          "S is any constant in a member"},
         {"midway", midway},
         F{"midway_S", spin, "1", "S of the member midway"}.record_only().shown("midway: S", " {:>13.9f}"),
         F{"midway_largest_multiplier", largest, "1", "its largest |multiplier|"}.record_only().shown("|multiplier|",
                                                                                                      " {:>12.8g}"),
         F{"midway_stability", stability, "", "its stability"}.flags(names).record_only().shown("stability", "  {}")}};
}

/// The chords of e = 1.
Table<DescribedChord> chord_table() {
    using F = Field<DescribedChord>;
    const auto of = [](auto member) { return [member](const DescribedChord& c) { return c.chord.*member; }; };
    const auto pair = [](int k) { return [k](const DescribedChord& c) { return std::abs(c.chord.multipliers[k]); }; };
    const auto multipliers = [](JsonWriter& json, const DescribedChord& c) {
        json.array(std::vector<std::complex<double>>(std::begin(c.chord.multipliers), std::end(c.chord.multipliers)));
    };
    const auto limit = [](const DescribedChord& c) {
        return c.speeds.fate == ChordFate::limit ? c.speeds.limit : no_value;
    };
    const auto fed_from = [](const DescribedChord& c) {
        return c.speeds.fate == ChordFate::limit ? c.speeds.fed_from : no_value;
    };
    return {
        {"chord"},
        {F{"a", of(&Chord::angle), "rad", "angle of the chord and the normal; 0: a diameter"}.shown("a", "  {:>10.6f}"),
         F{"j", of(&Chord::vertex_step), "1", "vertices on"}.shown("j", " {:>5}"),
         F{"turn", of(&Chord::turn), "rad", "S tau, by what the body turns in a flight"}.shown("S tau", " {:>9.5f}"),
         {"multipliers", multipliers},
         F{"first_multiplier", pair(0), "1", "largest |multiplier| across"}.record_only().shown("|pair|", " {:>8.5f}"),
         F{"second_multiplier", pair(1), "1", "the other"}.record_only().shown("", " {:>8.5f}"),
         {"attracts", [](const DescribedChord& c) { return c.chord.attracts(); }, "1", "do deviations decay?"},
         F{"fate", [](const DescribedChord& c) { return c.speeds.fate; }, "", "e = 1: where the swirl leads it"}
             .flags(names_up_to(ChordFate::accelerates))
             .shown("fate", "  {:<11}"),
         {"fed_from", fed_from, "R_c omega_s", "speed above which it gains; 0: from its resonance on"},
         F{"limit_speed", limit, "R_c omega_s", "v*"}.shown("v*", " {:>9.5f}"),
         F{"limit_S", &DescribedChord::limit_spin, "1", "S*"}.shown("S*", " {:>10.5f}"),
         F{"growth", &DescribedChord::growth, "1", "K: J^3 grows by 3/4 K beta^2 an impact"}.shown("K", " {:>9.6f}"),
         F{"balance_J", &DescribedChord::balance, "R_c^2 omega_s^2", "J* of e < 1"}.shown("J*", " {:>9.5f}")}};
}

/// Where a polygon rests on two vertices.
Table<EdgeRest> rest_table(const Scene<double>& scene) {
    using F = Field<EdgeRest>;
    const auto stability = [damped = scene.mu > 0](const EdgeRest& rest) {
        using analysis::Stability;
        if (!rest.restored) return Stability::unstable;
        return damped ? Stability::stable : Stability::neutral;
    };
    return {{"rest"},
            {F{"psi", &EdgeRest::psi, "rad", "direction of the edge's middle, less the swirl's"}.shown("psi",
                                                                                                       "  {:>12.9f}"),
             F{"force", &EdgeRest::force, "m R_c omega_s^2", "of the wall, normal to it, on both vertices"}.shown(
                 "force", " {:>12.9f}"),
             F{"stability", stability, "", "against sliding along the wall"}
                 .flags(names_up_to(analysis::Stability::neutral))
                 .shown("stability", "  {}")}};
}

void print_rests(const Description& d, const std::optional<Units>& units) {
    if (d.scene.is_disk()) return;
    if (d.rests.empty()) return fmt::print("  rest on the wall on two vertices, S = 1: none\n");
    fmt::print("  rest on the wall on two vertices, S = 1{}:\n",
               d.scene.restitution < 1 ? "" : " (e = 1: no impacts lead there)");
    print_table(in_units(rest_table(d.scene), units), d.rests);
}

/// Where S is free, the families are searched for up to some |S|.
std::string spins_in_words(const Description& d) {
    const bool free = d.steady.set == SteadySet::families && !d.scene.is_disk();
    return free ? fmt::format(" and |S| <= {:g}", d.search.fastest_spin) : "";
}

std::string counted(const Description& d) {
    if (d.steady.set == SteadySet::families) return fmt::format("{} families", d.families.size());
    long plus = 0;
    for (const auto& mode : d.steady.modes) plus += mode.branch == SteadyBranch::plus;
    const auto all = static_cast<long>(d.steady.modes.size());
    return fmt::format("{} ({} on branch +, {} on -)", all, plus, all - plus);
}

}  // namespace

void write_description_document(const DescribeOptions& options, const Description& d, const Settings& settings) {
    const bool disk = d.scene.is_disk();
    print_document([&](JsonWriter& json) {
        write_scene(json, d.scene, options.scene);
        write_members(json, fact_table(disk), d);
        json.key("rim");
        d.facts.rim ? write_object(json, rim_table(), *d.facts.rim) : json.null();
        write_json(json, "steady_modes", mode_table(disk, 0), d.steady.modes);
        write_json(json, "families", family_table(disk), d.families);
        write_json(json, "chords", chord_table(), d.chords);
        write_json(json, "rests", rest_table(d.scene), d.rests);
        json.key("none_exist");
        d.none_exist.empty() ? json.null() : json.value(d.none_exist);
        json.member("psi_is_free", d.steady.phase_is_free);
        json.member("complete", d.is_complete());
        json.member("complete_to", d.steady.complete_to);
        write_json(json, "settings", settings);
    });
}

void print_description(const Description& d, const std::optional<Units>& units) {
    const auto time = [&](double tau) { return with_unit(tau, units, "1/omega_s"); };
    const bool disk = d.scene.is_disk();
    fmt::print("{}\n{}{}", scene_in_words(d.scene), units_in_words(units),
               shown_lines_of(in_units(fact_table(disk, units), units), d));
    if (d.facts.rim) fmt::print("{}", shown_lines_of(in_units(rim_table(), units), *d.facts.rim));
    if (!d.chords.empty()) {
        fmt::print("  chords and diameters without slip (e = 1, small swirl){}:\n",
                   d.has_all_chords ? "" : ", those nearest to a diameter");
        print_table(in_units(chord_table(), units), d.chords);
    }
    print_rests(d, units);
    if (!d.none_exist.empty()) return fmt::print("{}\n", wrapped(fmt::format("  {}", d.none_exist), 4));
    fmt::print("  steady modes by impacts (none that stay on the wall) with tau <= {}{}: {}{}\n",
               time(d.search.longest_flight), spins_in_words(d), counted(d),
               d.is_complete() ? "" : fmt::format("; all up to tau = {}: there are more", time(d.steady.complete_to)));
    if (d.steady.phase_is_free) fmt::print("  psi of a steady mode is any constant (beta = 0); listed is psi = 0\n");
    if (!d.steady.modes.empty()) {
        print_table(in_units(mode_table(disk, 0, &d.steady.modes), units), d.steady.modes);
        fmt::print("  points: --json; to go on from one: -o FILE.h5, then swirl continue FILE.h5 --orbit I\n");
    }
    if (!d.families.empty()) print_table(in_units(family_table(disk), units), d.families);
}

void write_description_record(const RecordGroup& root, const Description& d, const Settings& settings) {
    const bool disk = d.scene.is_disk();
    write_scene(root, d.scene);
    write_attributes(root.group("settings"), settings);
    const RecordGroup facts = root.group("facts");
    write_attributes(facts, fact_table(disk), d);
    facts.attribute("none_exist", d.none_exist);
    facts.attribute("psi_is_free", d.steady.phase_is_free);
    facts.attribute("complete", d.is_complete());
    facts.attribute("complete_to", d.steady.complete_to);
    if (d.facts.rim) write_attributes(root.group("rim"), rim_table(), *d.facts.rim);
    if (!d.chords.empty()) write_record(root.group("chords"), chord_table(), d.chords);
    if (!d.families.empty()) write_record(root.group("families"), family_table(disk), d.families);
    if (!d.rests.empty()) write_record(root.group("rests"), rest_table(d.scene), d.rests);
    write_modes(root.group("steady_modes"), disk, d.steady.modes);
}

void write_modes(const RecordGroup& group, bool disk, const std::vector<SteadyMode>& modes) {
    if (modes.empty()) return;
    const int coordinates = disk ? disk_dimension : polygon_dimension;
    write_coordinate_names(group, coordinates);
    group.dimension("multiplier_index", static_cast<std::uint64_t>(coordinates));
    write_record(group, mode_table(disk, static_cast<std::size_t>(coordinates)), modes);
}

}  // namespace swirl::apps::describe
