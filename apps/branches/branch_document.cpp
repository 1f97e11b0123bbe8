#include "apps/branches/branch_document.hpp"

#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/itinerary_map.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace swirl::apps {

using analysis::Branch;
using analysis::NormalForm;
using analysis::SpecialKind;

namespace {

/// A cycle of a branch, or one of its special points.
struct PointRow {
    std::size_t branch;
    const analysis::BranchPoint* cycle;
    const analysis::SpecialPoint* special = nullptr;
};

std::vector<PointRow> points_of(const Branch& branch, std::size_t number) {
    std::vector<PointRow> rows;
    for (const auto& point : branch.points) rows.push_back({number, &point});
    return rows;
}

std::vector<PointRow> special_of(const Branch& branch, std::size_t number) {
    std::vector<PointRow> rows;
    for (const auto& special : branch.special) rows.push_back({number, &special.cycle, &special});
    return rows;
}

/// A coordinate of each point of a cycle.
std::vector<double> values_of(const PointRow& row, const std::string& observable) {
    std::vector<double> values;
    for (const auto& z : row.cycle->at.points()) values.push_back(z[place_of(observable, z.size())]);
    return values;
}

/// All coordinates of all points, one after another.
std::vector<double> all_coordinates_of(const PointRow& row) {
    std::vector<double> values;
    for (const auto& z : row.cycle->at.points()) values.insert(values.end(), z.begin(), z.end());
    return values;
}

/// An itinerary as text: vertex step and contact mode of each letter, "+1 sliding, +2 c-sticking"; empty if the map
/// ends.
std::string in_words(const std::vector<std::int64_t>& itinerary) {
    std::string text;
    for (const std::int64_t letter : itinerary) {
        const Letter l = letter_from(letter);
        text += fmt::format("{}{:+d} {}{}", text.empty() ? "" : ", ", l.vertex_step, name_of(l.mode),
                            l.through_contact ? " through contact" : "");
    }
    return text;
}

/// The cycles of branches along dimension `rows`. `longest`: the longest period, to which lists are filled up.
Table<PointRow> cycle_table(const SceneBranches& scene, const std::string& rows, const std::string& observable,
                            std::size_t longest) {
    using Row = PointRow;
    using F = Field<Row>;
    const auto of = [](auto member) { return [member](const Row& row) { return row.cycle->*member; }; };
    const auto parameter = [&scene](const Row& row) { return analysis::parameter_of(scene.options, row.cycle->at); };
    using Point = analysis::BranchPoint;
    return {{rows},
            {F{"branch", &Row::branch, "1", "number of the branch"}.record_only(),
             F{"period", [](const Row& row) { return row.cycle->at.shooting.period; }, "1", "k"}.record_only(),
             {"parameter", parameter, "1", "value of the parameter named by settings: along"},
             {"point", [](JsonWriter& json, const Row& row) { write_point(json, row.cycle->at.points().front()); }},
             F{"points", all_coordinates_of, "1", "section points; NaN beyond the period"}
                 .along({"phase", "coordinate"}, longest * static_cast<std::size_t>(scene.map.dimension))
                 .record_only(),
             F{"S", [](const Row& row) { return values_of(row, "S"); }, "1",
               "S after each impact of the cycle; NaN beyond it"}
                 .along({"phase"}, longest),
             F{"value", [=](const Row& row) { return values_of(row, observable); }, units_of_coordinate(observable),
               observable + " after each impact of the cycle; NaN beyond it"}
                 .along({"phase"}, longest)
                 .record_only()
                 .when(observable != "S"),
             {"mean_S", of(&Point::mean), "1", "time mean of S"},
             {"return_time", [](const Row& row) { return row.cycle->at.shooting.duration; }, "1/omega_s",
              "sum of the flights"},
             {"multipliers", [](JsonWriter& json, const Row& row) { json.array(row.cycle->multipliers); }},
             F{"largest_multiplier", [](const Row& row) { return std::abs(row.cycle->multipliers.front()); }, "1",
               "modulus"}
                 .record_only(),
             {"index", of(&Point::index), "1", "multipliers outside the unit circle"},
             F{"stability", of(&Point::stability), no_column},
             F{"stable", [](const Row& row) { return row.cycle->stability != analysis::Stability::unstable; }, "1",
               "1: no multiplier outside the unit circle"}
                 .stored_as(ElementType::int64)
                 .record_only(),
             {"residual", [](const Row& row) { return row.cycle->at.shooting.residual(); }, "1",
              "largest |F(z_i) - z_(i+1)|"}},
            {"branch", "period", "stable", "index", "parameter", "mean_S", "return_time", "largest_multiplier",
             "residual", "S"}};
}

void write_normal_form(JsonWriter& json, const PointRow& row) {
    const NormalForm& form = *row.special->normal_form;
    json.begin_object();
    json.member("parameter", form.parameter);
    json.member("nonlinear", form.nonlinear);
    if (row.special->kind == SpecialKind::neimark_sacker) json.member("angle", form.angle);
    if (row.special->kind != SpecialKind::fold) json.member("supercritical", form.supercritical);
    json.end_object();
}

/// 1 yes, 0 no, -1 does not apply.
std::int64_t supercritical(const PointRow& row) {
    if (!row.special->normal_form || row.special->kind == SpecialKind::fold) return -1;
    return row.special->normal_form->supercritical ? 1 : 0;
}

/// What special points have beyond a cycle's fields. NaN: no normal form.
std::vector<Field<PointRow>> special_fields() {
    using Row = PointRow;
    using F = Field<Row>;
    using Special = analysis::SpecialPoint;
    const auto border = [](const Row& row) { return row.special->kind == SpecialKind::border; };
    const auto has_form = [](const Row& row) { return row.special->normal_form.has_value(); };
    const auto of = [](auto member) { return [member](const Row& row) { return row.special->*member; }; };
    const auto itinerary = [border](const char* name, std::vector<std::int64_t> Special::*member,
                                    const char* long_name) {
        return F{name, [=](const Row& row) { return border(row) ? in_words(row.special->*member) : ""; }, "", long_name}
            .json_written([=](JsonWriter& json, const Row& row) { write_itinerary(json, row.special->*member); })
            .json_if(border);
    };
    const auto form = [](const char* name, auto part, const char* units, const char* long_name) {
        const auto value = [part](const Row& row) {
            return row.special->normal_form ? part(*row.special) : std::numeric_limits<double>::quiet_NaN();
        };
        return F{name, value, units, long_name}.record_only();
    };
    const auto angle = [](const Special& s) {
        return s.kind == SpecialKind::neimark_sacker ? s.normal_form->angle : std::numeric_limits<double>::quiet_NaN();
    };
    return {
        F{"after", of(&Special::after), "1", "point of the branch that it comes after; the first is 0"},
        F{"located", of(&Special::located), "1", "0: known only to lie between two points"}
            .stored_as(ElementType::int64)
            .json_if([](const Row& row) { return !row.special->located; }),
        F{"normal_form", write_normal_form}.json_if(has_form),
        itinerary("word_before", &Special::itinerary_before, "of a border: vertex steps and contact modes before it"),
        itinerary("word_after", &Special::itinerary_after, "of a border: the same behind it"),
        F{"goes_on", of(&Special::goes_on), "1", "0: no cycle was found behind the border"}
            .stored_as(ElementType::int64)
            .json_if(border),
        F{"supercritical", supercritical, "1", "1 yes, 0 no, -1 does not apply"}.record_only(),
        form(
            "form_parameter_re", [](const Special& s) { return s.normal_form->parameter.real(); }, "1",
            "normal form: a"),
        form(
            "form_parameter_im", [](const Special& s) { return s.normal_form->parameter.imag(); }, "1",
            "normal form: a"),
        form(
            "form_nonlinear_re", [](const Special& s) { return s.normal_form->nonlinear.real(); }, "1",
            "normal form: b"),
        form(
            "form_nonlinear_im", [](const Special& s) { return s.normal_form->nonlinear.imag(); }, "1",
            "normal form: b"),
        form("form_angle", angle, "rad", "normal form: theta")};
}

Table<PointRow> special_table(const SceneBranches& scene, const std::string& observable, std::size_t longest) {
    Table<PointRow> table = cycle_table(scene, "special_point", observable, longest);
    table.fields.insert(table.fields.begin(), {"kind", [](const PointRow& row) { return kind_of(*row.special); }, "",
                                               "bifurcation, or border of the map"});
    const auto more = special_fields();
    table.fields.insert(table.fields.end(), more.begin(), more.end());
    table.first_in_record.insert(table.first_in_record.end(), {"value", "kind", "word_before", "word_after"});
    return table;
}

/// The branches, with their points and special points in JSON.
Table<Branch> branch_table(const SceneBranches& scene) {
    using F = Field<Branch>;
    const auto is_switched = [](const Branch& branch) { return branch.parent >= 0; };
    const auto itinerary = [](const Branch& branch) { return branch.points.front().at.shooting.itinerary; };
    const auto points = [&](JsonWriter& json, const Branch& branch) {
        write_rows(json, cycle_table(scene, "", "S", 1), points_of(branch, 0));
    };
    const auto special = [&](JsonWriter& json, const Branch& branch) {
        write_rows(json, special_table(scene, "S", 1), special_of(branch, 0));
    };
    return {
        {"branch"},
        {{"period", &Branch::period, "1", "k"},
         {"begins", &Branch::begin, "", "why the branch begins at its first point"},
         {"ends", &Branch::end, "", "why it ends at its last"},
         F{"switched_from", &Branch::parent, "1", "a branch; -1: none"}.json_if(is_switched),
         F{"switched_at", &Branch::parent_special, "1", "that branch's special point; -1: none"}.json_if(is_switched),
         F{"word", [itinerary](const Branch& b) { return in_words(itinerary(b)); }, "",
           "vertex step and contact mode of each impact"}
             .json_written([itinerary](JsonWriter& json, const Branch& b) { write_itinerary(json, itinerary(b)); }),
         {"points", points},
         {"special", special}},
        {"period", "begins", "ends", "word"}};
}

void write_points(const RecordGroup& group, const Table<PointRow>& table, const std::vector<PointRow>& rows,
                  std::size_t longest) {
    group.dimension(table.dimensions.front(), rows.size());
    group.dimension("phase", longest);
    write_coordinate_names(group, rows.front().cycle->at.shooting.dimension);
    write_columns(group, table, rows);
}

}  // namespace

void write_branches(JsonWriter& json, const SceneBranches& scene, const std::vector<Branch>& branches) {
    json.key("branches");
    json.begin_array(JsonLayout::rows);
    const auto table = branch_table(scene);
    for (const auto& branch : branches) {
        json.begin_object(JsonLayout::rows);
        write_members(json, table, branch);
        json.end_object();
    }
    json.end_array();
}

void write_branches(const RecordGroup& root, const SceneBranches& scene, const std::vector<Branch>& branches,
                    const std::string& observable) {
    std::size_t longest = 1;
    std::vector<PointRow> points, special;
    for (std::size_t b = 0; b < branches.size(); ++b) {
        longest = std::max(longest, branches[b].period());
        for (const auto& row : points_of(branches[b], b)) points.push_back(row);
        for (const auto& row : special_of(branches[b], b)) special.push_back(row);
    }
    if (!points.empty()) {
        write_points(root.group("branches"), cycle_table(scene, "point", observable, longest), points, longest);
        write_record(root.group("branch_ends"), branch_table(scene), branches);
    }
    if (!special.empty())
        write_points(root.group("special"), special_table(scene, observable, longest), special, longest);
}

void print_branches(const SceneBranches& scene, const ParameterRange& along,
                    const std::vector<analysis::Branch>& branches, const std::optional<Units>& units) {
    const bool by_time = along.name == "tau";
    const char* unit = by_time && units ? " s" : "";
    const auto value = [&](const analysis::BranchPoint& point) {
        const double parameter = analysis::parameter_of(scene.options, point.at);
        return by_time ? in_units(parameter, units, "1/omega_s") : parameter;
    };
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const auto& branch = branches[b];
        std::string line = fmt::format("branch {}, period {}: {} points, {} from {:.8g}{} ({}) to {:.8g}{} ({})", b,
                                       branch.period(), branch.points.size(), along.name, value(branch.points.front()),
                                       unit, analysis::name_of(branch.begin), value(branch.points.back()), unit,
                                       analysis::name_of(branch.end));
        if (branch.parent >= 0) line += fmt::format(", from branch {}", branch.parent);
        fmt::print("{}\n", wrapped(line, 4));
        for (const auto& special : branch.special) {
            const auto& c = special.cycle;
            line =
                fmt::format("  {:<15} {} = {:.10f}{}  S {:>13.10f}  |multiplier| {:.6f}", kind_of(special), along.name,
                            value(c), unit, c.at.points().front().tail(1)[0], std::abs(c.multipliers.front()));
            if (!special.located) line += "  between two points";
            if (special.normal_form && special.kind != analysis::SpecialKind::fold)
                line += special.normal_form->supercritical ? "  supercritical" : "  subcritical";
            fmt::print("{}\n", wrapped(line, 18));
        }
    }
}

}  // namespace swirl::apps
