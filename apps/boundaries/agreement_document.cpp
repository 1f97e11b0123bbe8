#include "apps/boundaries/boundaries_command.hpp"

#include <fmt/format.h>

#include <cstddef>

namespace swirl::apps::boundaries {

void write_agreement(JsonWriter& json, const Plane& plane, const Agreement& agreement) {
    json.key("against");
    json.begin_object(JsonLayout::rows);
    json.member("cells", agreement.cells);
    json.member("with_cycle", agreement.with_cycle);
    json.member("unseen_cells", agreement.unseen_cells);
    json.member("missing_cells", agreement.missing_cells);
    json.member("led_by_runs", agreement.led_by_runs);
    json.member("family_cells", agreement.family_cells);
    json.member("outside_cells", agreement.outside_cells);
    json.key("disagreements");
    json.begin_array(JsonLayout::rows);
    for (const auto& entry : agreement.list) {
        json.begin_object();
        json.key("parameters");
        json.begin_object();
        for (int axis = 0; axis < 2; ++axis)
            json.member(plane.axes[static_cast<std::size_t>(axis)].name, entry.parameters[axis]);
        json.end_object();
        json.member("period", entry.period);
        json.member("mean_S", entry.mean_spin);
        json.member("why", entry.why);
        json.end_object();
    }
    json.end_array();
    json.end_object();
}

void print_agreement(const Plane& plane, const Agreement& agreement) {
    const auto share = [&](std::size_t count) {
        return agreement.cells == 0 ? 0 : 100.0 * static_cast<double>(count) / static_cast<double>(agreement.cells);
    };
    const auto line = [&](std::size_t count, const char* what) {
        fmt::print("  {:>7} {:>6.2f} %  {}\n", count, share(count), what);
    };
    fmt::print("compared with the map: {} cells; the curves predict attracting cycles in {}\n", agreement.cells,
               agreement.with_cycle);
    line(agreement.missing_cells, "have a run that came to a cycle to which no curve leads");
    line(agreement.unseen_cells, "have an attracting cycle to which no run came");
    line(agreement.led_by_runs, "have a cycle to which only the map's own runs led");
    if (agreement.family_cells > 0)
        line(agreement.family_cells, "have a run that came to a member of a family, which is not compared");
    if (agreement.outside_cells > 0)
        fmt::print("  {} cells lie outside the plane and are not compared\n", agreement.outside_cells);
    for (const auto& entry : agreement.list)
        fmt::print("  {} = {:<9.6g} {} = {:<9.6g} period {:<3} mean S {:>13.9f}  {}\n", plane.axes[0].name,
                   entry.parameters[0], plane.axes[1].name, entry.parameters[1], entry.period, entry.mean_spin,
                   entry.why);
}

}  // namespace swirl::apps::boundaries
