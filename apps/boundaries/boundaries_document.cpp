#include "analysis/cycles/cycle.hpp"
#include "analysis/special_values.hpp"
#include "apps/boundaries/boundaries_command.hpp"
#include "apps/branches/section_point.hpp"
#include "apps/output/write_table.hpp"
#include "apps/studies/scene_map/section_coordinates.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <complex>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace swirl::apps::boundaries {

namespace {

/// A cycle of a curve, or one of its special points.
struct CycleRow {
    std::size_t curve;
    const CurveCycle* cycle;
    const CurveSpecial* special = nullptr;
};

std::vector<double> all_coordinates_of(const CycleRow& row) {
    std::vector<double> values;
    for (const auto& z : row.cycle->points) values.insert(values.end(), z.begin(), z.end());
    return values;
}

/// What is known of a cycle on a border beside its points; NaN and "none" of the others.
std::vector<Field<CycleRow>> border_fields(std::size_t longest) {
    using Row = CycleRow;
    using F = Field<Row>;
    std::vector<std::string> touches(touch_names.begin(), touch_names.end());
    touches.insert(touches.begin(), "none");
    const auto times = [](const Row& row) {
        return row.cycle->border ? row.cycle->border->times : std::vector<double>();
    };
    const auto vertices = [](const Row& row) {
        return row.cycle->border
                   ? std::vector<double>(row.cycle->border->vertices.begin(), row.cycle->border->vertices.end())
                   : std::vector<double>();
    };
    const auto touch = [](const Row& row) {
        return row.cycle->border ? touch_names.at(static_cast<std::size_t>(row.cycle->border->touch)) : "none";
    };
    const auto vertex = [](const Row& row) { return row.cycle->border ? row.cycle->border->vertex : 0; };
    const auto time = [](const Row& row) {
        return row.cycle->border && row.cycle->border->touch == Touch::grazing ? row.cycle->border->touch_time
                                                                               : analysis::nan;
    };
    return {
        F{"touch", touch, "", "what is the case on the first flight of a cycle on a border"}
            .flags(std::move(touches))
            .record_only(),
        F{"touching_vertex", vertex, "1", "counted from the one that struck before"}.record_only(),
        F{"touch_time", time, "1/omega_s", "from the first flight's beginning; of grazing"}.record_only(),
        F{"flight_times", times, "1/omega_s", "of cycles on a border"}.along({"phase"}, longest).record_only(),
        F{"vertex_steps", vertices, "1", "of cycles on a border: the vertex at a flight's end, counted from the last"}
            .along({"phase"}, longest)
            .record_only()};
}

void write_parameters(JsonWriter& json, const Plane& plane, const Eigen::Vector2d& p) {
    json.begin_object();
    for (int axis = 0; axis < 2; ++axis) json.member(plane.axes[static_cast<std::size_t>(axis)].name, p[axis]);
    json.end_object();
}

/// The cycles of curves along dimension `rows`. `longest`: the longest period, to which lists are filled up.
Table<CycleRow> cycle_table(const Plane& plane, const std::string& rows, std::size_t longest, std::size_t coordinates) {
    using Row = CycleRow;
    using F = Field<Row>;
    const auto parameter = [](int axis) { return [axis](const Row& row) { return row.cycle->parameters[axis]; }; };
    Table<Row> table{
        {rows},
        {F{"curve", &Row::curve, "1", "number of the curve"}.record_only(),
         F{"period", [](const Row& row) { return row.cycle->points.size(); }, "1", "k"}.record_only(),
         {"parameters",
          [plane](JsonWriter& json, const Row& row) { write_parameters(json, plane, row.cycle->parameters); }},
         F{"first", parameter(0), "1", "value of the parameter named by settings: first"}.record_only(),
         F{"second", parameter(1), "1", "value of the parameter named by settings: second"}.record_only(),
         {"point", [](JsonWriter& json, const Row& row) { write_point(json, row.cycle->points.front()); }},
         F{"points", all_coordinates_of, "1", "section points; NaN beyond the period"}
             .along({"phase", "coordinate"}, longest * coordinates)
             .record_only(),
         {"multipliers", [](JsonWriter& json, const Row& row) { json.array(row.cycle->multipliers); }},
         F{"largest_multiplier", [](const Row& row) { return std::abs(row.cycle->multipliers.front()); }, "1",
           "modulus"}
             .record_only(),
         F{"angle", [](const Row& row) { return row.cycle->angle; }, "rad", "theta of the critical multiplier"}
             .record_only(),
         {"coefficient", [](JsonWriter& json, const Row& row) { json.value(row.cycle->coefficient); }},
         F{"coefficient_re", [](const Row& row) { return row.cycle->coefficient.real(); }, "1", "normal form: b"}
             .record_only(),
         F{"coefficient_im", [](const Row& row) { return row.cycle->coefficient.imag(); }, "1", "normal form: b"}
             .record_only()}};
    const auto border = border_fields(longest);
    table.fields.insert(table.fields.end(), border.begin(), border.end());
    return table;
}

Table<CycleRow> special_table(const Plane& plane, std::size_t longest, std::size_t coordinates) {
    Table<CycleRow> table = cycle_table(plane, "special_point", longest, coordinates);
    table.fields.insert(table.fields.begin(), {"kind", [](const CycleRow& row) { return row.special->kind; }, "",
                                               "kind of the special point"});
    table.fields.push_back({"after", [](const CycleRow& row) { return row.special->after; }, "1",
                            "point of the curve that it comes after; the first is 0"});
    return table;
}

std::vector<CycleRow> points_of(const Curve& curve, std::size_t number) {
    std::vector<CycleRow> rows;
    for (const auto& point : curve.points) rows.push_back({number, &point});
    return rows;
}

std::vector<CycleRow> special_of(const Curve& curve, std::size_t number) {
    std::vector<CycleRow> rows;
    for (const auto& special : curve.special) rows.push_back({number, &special.cycle, &special});
    return rows;
}

/// Does a cycle attract on one side of the curve, somewhere along it?
bool bounds_attracting(const Curve& curve) {
    return std::any_of(curve.points.begin(), curve.points.end(), [](const CurveCycle& point) {
        return !point.multipliers.empty() && std::abs(point.multipliers.front()) < 1 + analysis::neutral_margin;
    });
}

Table<Curve> curve_table(const Plane& plane) {
    using F = Field<Curve>;
    const auto points = [plane](JsonWriter& json, const Curve& curve) {
        write_rows(json, cycle_table(plane, "", 1, 1), points_of(curve, 0));
    };
    const auto special = [plane](JsonWriter& json, const Curve& curve) {
        write_rows(json, special_table(plane, 1, 1), special_of(curve, 0));
    };
    const auto ends = [](JsonWriter& json, const Curve& curve) {
        json.array(std::vector<std::string>{curve.begins, curve.ends});
    };
    return {{"curve"},
            {{"kind", &Curve::kind, "", "bifurcation, or border of the map"},
             {"period", &Curve::period, "1", "k"},
             F{"bounds_attracting", bounds_attracting, "1",
               "1: at a point of the curve no multiplier lies outside the unit circle"},
             {"points", points},
             {"special", special},
             {"ends", ends},
             F{"begins_at", &Curve::begins, "", "why the curve begins at its first point"}.record_only(),
             F{"ends_at", &Curve::ends, "", "why it ends at its last"}.record_only()}};
}

void write_cycles(const RecordGroup& group, const Table<CycleRow>& table, const std::vector<CycleRow>& rows,
                  std::size_t longest) {
    group.dimension(table.dimensions.front(), rows.size());
    group.dimension("phase", longest);
    write_coordinate_names(group, rows.front().cycle->points.front().size());
    write_columns(group, table, rows);
}

/// How many curves of each kind and period there are, in words.
std::string counts_of(const std::vector<Curve>& curves) {
    std::map<std::string, int> counts;
    for (const auto& curve : curves) ++counts[curve.kind];
    std::string text;
    for (const auto& [kind, count] : counts) text += fmt::format("{}{} {}", text.empty() ? "" : ", ", count, kind);
    return text.empty() ? "none" : text;
}

std::string outcome_of(const PlaneCurves& found) {
    return found.whole ? "completed" : "interrupted";
}

/// What lines met of the curves: `even` lines and those `between` them.
Settings survey_values(const LineSurvey& survey) {
    return {{"even", static_cast<std::int64_t>(survey.even)},
            {"between", static_cast<std::int64_t>(survey.between)},
            {"curves", static_cast<std::int64_t>(survey.met)},
            {"curves_of_even", static_cast<std::int64_t>(survey.met_by_even)},
            {"met_once", static_cast<std::int64_t>(survey.lone)},
            {"missed_by_even", survey.by_even.missed},
            {"least_missed_by_even", survey.by_even.least_missed},
            {"most_missed_by_even", survey.by_even.most_missed}};
}

Table<CycleSearches> search_table() {
    return {{"search"},
            {{"period", &CycleSearches::period, "1", "k"},
             {"places", &CycleSearches::places, "1", "on lines, where cycles of the period were searched for"},
             {"cycles", &CycleSearches::found, "1", "found, of all places together"},
             {"missed", &CycleSearches::missed, "1", "estimate of cycles not found there (Chao 1984)"}}};
}

void print_survey(const LineSurvey& survey) {
    fmt::print("{} evenly spaced lines meet {} curves", survey.even, survey.met_by_even);
    if (survey.by_even.missed >= 0.5)
        fmt::print("; some {:.0f} more are to be expected (95 %: {:.0f} to {:.0f})", survey.by_even.missed,
                   survey.by_even.least_missed, survey.by_even.most_missed);
    fmt::print("\n{} lines between them meet {} others; {} curves are met by one line alone\n", survey.between,
               survey.met - survey.met_by_even, survey.lone);
    for (const CycleSearches& search : survey.searches)
        fmt::print("cycles of period {}: {} at {} places on lines; some {:.0f} more are to be expected there\n",
                   search.period, search.found, search.places, search.missed);
}

}  // namespace

void write_curves_document(const BoundariesOptions& options, const Scene<double>& scene, const Plane& plane,
                           const FoundCurves& all, const std::optional<Agreement>& agreement) {
    const PlaneCurves& found = all.curves;
    print_document([&](JsonWriter& json) {
        write_json(json, "scene", scene_settings_of(scene, plane));
        if (const auto units = options.scene.units()) write_json(json, "units", unit_settings(*units));
        write_json(json, "curves", curve_table(plane), found.curves);
        json.member("outcome", outcome_of(found));
        json.member("seeds", found.starting_points);
        json.member("without_curve", found.without);
        json.list("not_followed", found.left_out);
        if (all.survey) {
            write_json(json, "lines", survey_values(*all.survey));
            write_json(json, "searches", search_table(), all.survey->searches);
        }
        if (agreement) write_agreement(json, plane, *agreement);
        write_json(json, "settings", settings_of(options, plane));
    });
}

void write_curves_record(RecordWriter& record, const BoundariesOptions& options, const Scene<double>& scene,
                         const Plane& plane, const FoundCurves& all) {
    const PlaneCurves& found = all.curves;
    const auto root = record.root();
    write_attributes(root.group("scene"), scene_settings_of(scene, plane));
    write_attributes(root.group("settings"), settings_of(options, plane));
    write_attributes(root.group("result"), {{"outcome", outcome_of(found)}});
    if (all.survey) {
        write_attributes(root.group("lines"), survey_values(*all.survey));
        if (!all.survey->searches.empty()) write_record(root.group("searches"), search_table(), all.survey->searches);
    }
    std::size_t longest = 1;
    std::vector<CycleRow> points, special;
    for (std::size_t c = 0; c < found.curves.size(); ++c) {
        longest = std::max(longest, found.curves[c].period);
        for (const auto& row : points_of(found.curves[c], c)) points.push_back(row);
        for (const auto& row : special_of(found.curves[c], c)) special.push_back(row);
    }
    const auto coordinates = static_cast<std::size_t>(scene.is_disk() ? disk_dimension : polygon_dimension);
    if (!points.empty()) {
        write_cycles(root.group("curves"), cycle_table(plane, "point", longest, coordinates), points, longest);
        write_record(root.group("curve_ends"), curve_table(plane), found.curves);
    }
    if (!special.empty())
        write_cycles(root.group("special"), special_table(plane, longest, coordinates), special, longest);
}

void print_curves(const Plane& plane, const FoundCurves& all) {
    const PlaneCurves& found = all.curves;
    const auto place = [&](const Eigen::Vector2d& p) { return fmt::format("({:.4g}, {:.4g})", p[0], p[1]); };
    fmt::print("curves in ({}, {})\n", plane.axes[0].name, plane.axes[1].name);
    fmt::print("{:>5}  {:<14} {:>6} {:>6}  {:<30}  {}\n", "curve", "kind", "period", "points", "from", "to");
    for (std::size_t c = 0; c < found.curves.size(); ++c) {
        const Curve& curve = found.curves[c];
        fmt::print("{:>5}  {:<14} {:>6} {:>6}  {:<30}  {}\n", c, curve.kind, curve.period, curve.points.size(),
                   place(curve.points.front().parameters) + " " + curve.begins,
                   place(curve.points.back().parameters) + " " + curve.ends);
        for (const auto& special : curve.special)
            fmt::print("       {:<22} {} = {:.10f}  {} = {:.10f}\n", special.kind, plane.axes[0].name,
                       special.cycle.parameters[0], plane.axes[1].name, special.cycle.parameters[1]);
    }
    fmt::print("{} curves: {}; sought from {} special points, {} of which led to none\n", found.curves.size(),
               counts_of(found.curves), found.starting_points, found.without);
    if (all.survey) print_survey(*all.survey);
    for (const auto& kind : found.left_out) fmt::print("not followed: {}\n", kind);
    if (!found.whole) fmt::print("interrupted: curves are missing\n");
}

}  // namespace swirl::apps::boundaries
