#include "apps/certify/certificate_file.hpp"

#include "apps/command_line/errors.hpp"
#include "apps/command_line/record_files.hpp"
#include "apps/command_line/text_file.hpp"
#include "apps/record/record_error.hpp"

#include <fmt/format.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <cerrno>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <set>
#include <system_error>
#include <utility>

namespace swirl::apps::certify {

namespace {

using Json = nlohmann::json;
using proof_check::StatedCycle;
using proof_check::StatedStep;

constexpr std::string_view before_checksum = ",\n  \"checksum\": \"crc-64/xz ";

std::uint64_t crc_of(std::string_view bytes) {
    boost::crc_optimal<64, 0x42F0E1EBA9EA3693U, ~std::uint64_t{0}, ~std::uint64_t{0}, true, true> crc;
    crc.process_bytes(bytes.data(), bytes.size());
    return crc.checksum();
}

std::string tail_of(std::string_view document) {
    return fmt::format("{}{:016x}\"\n}}\n", before_checksum, crc_of(document));
}

/// A whole number. (The library's conversion would cut off what follows the point.)
int whole(const Json& number) {
    if (number.is_number_integer()) {
        const int value = number.get<int>();
        if (number == value) return value;
    }
    throw BadInput(fmt::format("{} is no whole number, or far too large", number.dump()));
}

std::array<double, 5> coordinates_in(const Json& z) {
    const auto at = [&z](const char* name) { return z.at(name).get<double>(); };
    return {at("psi"), z.contains("chi") ? at("chi") : 0.0, at("vn"), at("vt"), at("S")};
}

/// What else a scene may state (a floor that drags, rounded corners) is in no certificate, and would not be proven.
void read_scene(const Json& scene, StatedCycle& cycle) {
    static const std::set<std::string> proven = {"sides",       "alpha", "beta",          "mu",
                                                 "restitution", "law",   "inertia_factor"};
    for (const auto& [name, value] : scene.items())
        if (!proven.contains(name))
            throw BadInput(fmt::format("its scene states '{}', which no proof is extended to", name));
    const Json& sides = scene.at("sides");
    cycle.sides = sides.is_string() ? (sides.get<std::string>() == "disk" ? 0 : -1) : whole(sides);
    cycle.alpha = scene.at("alpha").get<double>();
    cycle.beta = scene.at("beta").get<double>();
    cycle.mu = scene.at("mu").get<double>();
    cycle.restitution = scene.at("restitution").get<double>();
    cycle.law = scene.at("law").get<std::string>();
    cycle.inertia_factor = scene.at("inertia_factor").get<double>();
}

/// The parameter in which an orbit's scene differs from the document's.
void read_parameters(const Json& parameters, StatedCycle& cycle) {
    for (const auto& [name, value] : parameters.items()) {
        double* const place = name == "alpha"            ? &cycle.alpha
                              : name == "beta"           ? &cycle.beta
                              : name == "mu"             ? &cycle.mu
                              : name == "restitution"    ? &cycle.restitution
                              : name == "inertia-factor" ? &cycle.inertia_factor
                                                         : nullptr;
        if (place == nullptr) throw BadInput(fmt::format("'{}' is no parameter of a scene", name));
        *place = value.get<double>();
    }
}

StatedCycle cycle_in(const Json& document, const Json& orbit) {
    StatedCycle cycle;
    read_scene(document.at("scene"), cycle);
    const auto inertia = orbit.at("inertia").get<std::string>();
    if (inertia != "uniform lamina" && inertia != "as given")
        throw BadInput(fmt::format("inertia '{}' is neither 'uniform lamina' nor 'as given'", inertia));
    cycle.uniform_lamina = inertia == "uniform lamina";
    read_parameters(orbit.at("parameters"), cycle);
    for (const Json& step : orbit.at("steps")) {
        StatedStep stated;
        stated.point = coordinates_in(step.at("point"));
        stated.radius = coordinates_in(step.at("half_widths"));
        stated.time = step.at("flight_time").get<double>();
        stated.time_radius = step.at("flight_time_half_width").get<double>();
        stated.vertex_step = whole(step.at("vertex_step"));
        stated.contact_mode = step.at("contact_mode").get<std::string>();
        stated.slip = whole(step.at("slip"));
        cycle.steps.push_back(stated);
    }
    for (const Json& disc : orbit.at("multipliers"))
        cycle.multipliers.push_back({disc.at(0).get<double>(), disc.at(1).get<double>(), disc.at(2).get<double>()});
    cycle.stability = orbit.at("stability").get<std::string>();
    const Json& phase = orbit.at("phase");
    if (!phase.is_null()) {
        const bool by_time = phase.contains("tau");
        cycle.phase = StatedCycle::Phase{by_time, phase.at(by_time ? "tau" : "S").get<double>()};
    }
    if (whole(orbit.at("period")) != static_cast<int>(cycle.steps.size()))
        throw BadInput(
            fmt::format("its period is {}, but it has {} steps", orbit.at("period").dump(), cycle.steps.size()));
    // What is said twice is said alike.
    double widest = 0;
    for (const StatedStep& step : cycle.steps) {
        widest = std::max(widest, step.time_radius);
        for (const double radius : step.radius) widest = std::max(widest, radius);
    }
    if (!cycle.steps.empty() &&
        (orbit.at("radius").get<double>() != widest || coordinates_in(orbit.at("point")) != cycle.steps[0].point))
        throw BadInput("its point and radius are not those of its steps");
    return cycle;
}

std::array<double, 2> range_in(const Json& range) {
    if (range.size() != 2) throw BadInput("a range has not two ends");
    return {range.at(0).get<double>(), range.at(1).get<double>()};
}

/// The cells that are stated as proven, and that their number and share are as stated.
proof_check::StatedPlane plane_in(const Json& document) {
    proof_check::StatedPlane plane;
    const Json& settings = document.at("settings");
    plane.names = {settings.at("first").get<std::string>(), settings.at("second").get<std::string>()};
    plane.max_time = settings.at("max_time").get<double>();
    Json scene = document.at("scene");
    for (std::size_t i = 0; i < 2; ++i) {
        const auto [low, high] = range_in(document.at("plane").at(plane.names[i]));
        plane.plane.low[i] = low;
        plane.plane.high[i] = high;
        scene[plane.names[i] == "inertia-factor" ? "inertia_factor" : plane.names[i]] = low;
    }
    read_scene(scene, plane.scene);
    plane.scene.uniform_lamina = document.at("inertia").get<std::string>() == "uniform lamina" &&
                                 plane.names[0] != "inertia-factor" && plane.names[1] != "inertia-factor";
    double area = 0;
    for (const Json& row : document.at("cells")) {
        if (!row.at("proven").get<bool>()) continue;
        cells::PlaneCell cell;
        double share = 1;
        for (std::size_t i = 0; i < 2; ++i) {
            const auto [low, high] = range_in(row.at("box").at(plane.names[i]));
            cell.low[i] = low;
            cell.high[i] = high;
            share *= (high - low) / (plane.plane.high[i] - plane.plane.low[i]);
        }
        cell.proven = true;
        cell.fixed_points = whole(row.at("fixed_points"));
        cell.attracting = whole(row.at("attracting"));
        cell.saddles = whole(row.at("saddles"));
        cell.repelling = whole(row.at("repelling"));
        area += share;
        plane.proven.push_back(cell);
    }
    const double stated = document.at("proven_area").get<double>();
    if (static_cast<std::size_t>(whole(document.at("proven"))) != plane.proven.size() ||
        !(std::abs(area - stated) < 1e-9))
        throw BadInput("the number or the share of its proven cells is not that of its cells");
    return plane;
}

using StatedBoxes = std::vector<proof_check::StatedBox>;

/// Of a box by its multipliers, as `stability` names it.
std::string stability_of(const proof_check::StatedBox& box) {
    if (!box.decided) return "undecided";
    return box.outside == 0 ? "attracting" : box.inside == 0 ? "repelling" : "saddle";
}

/// The stretches of `stability` are those of the boxes.
void require_stretches(const Json& row, const StatedBoxes& boxes) {
    std::vector<std::string> stretches;
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        const bool same = i > 0 && boxes[i].decided == boxes[i - 1].decided &&
                          (!boxes[i].decided || boxes[i].outside == boxes[i - 1].outside);
        if (!same) stretches.push_back(stability_of(boxes[i]));
    }
    const Json& stated = row.at("stability");
    const bool equal =
        stated.size() == stretches.size() &&
        std::equal(stated.begin(), stated.end(), stretches.begin(), [](const Json& one, const auto& name) {
            return one.at("stability").template get<std::string>() == name;
        });
    if (!equal) throw BadInput("what is said of a branch's stability is not what its boxes say");
}

/// The boxes of which the stability is not decided lie between the two parameters.
bool holds_boxes(const StatedBoxes& boxes, const proof_check::StatedSpecial& special) {
    return std::all_of(boxes.begin() + static_cast<std::ptrdiff_t>(special.first),
                       boxes.begin() + static_cast<std::ptrdiff_t>(special.last), [&](const auto& box) {
                           const bool runs = box.running + 1 == box.middle.size();
                           return runs ? special.low <= box.low && special.high >= box.high
                                       : special.low <= box.middle.back() + box.within &&
                                             special.high >= box.middle.back() - box.within;
                       });
}

/// One of `special`, which is about boxes first … last − 1, whose stability is not decided: their number of multipliers
/// before and after is compared here; the place of one that is stated as proven is what the check is about.
void read_special(const Json& row, std::size_t first, std::size_t last, proof_check::StatedBranch& branch) {
    const int before = branch.boxes[first - 1].outside, after = branch.boxes[last].outside;
    const Json& place = row.at("box");
    if (place.size() != 1 || !place.contains(branch.parameter))
        throw BadInput("a special point of a branch lies along its parameter");
    const auto [low, high] = range_in(place.begin().value());
    proof_check::StatedSpecial special{row.at("kind").get<std::string>(), {}, 0, low, high, 0, 0, first, last};
    const bool is_pair = special.kind == "neimark-sacker";
    const int crossed = std::abs(after - before);
    const bool named = ((special.kind == "fold" || special.kind == "flip") && crossed == 1) ||
                       (is_pair && crossed == 2) || (special.kind == "change" && crossed > 2);
    const bool proven = row.at("proven").get<bool>();
    if (!named || (proven && crossed > 2) || whole(row.at("outside_before")) != before ||
        whole(row.at("outside_after")) != after || !(proven || holds_boxes(branch.boxes, special)))
        throw BadInput("a special point of a branch is not what its boxes say");
    if (!proven) return;
    special.middle = row.at("middle").get<std::vector<double>>();
    special.within = row.at("within").get<double>();
    if (is_pair) {
        const auto [least, most] = range_in(row.at("angle"));
        special.angle_low = least;
        special.angle_high = most;
    }
    branch.special.push_back(std::move(special));
}

/// Every one of `special` is what boxes say, and none that they say is missing.
void read_specials(const Json& row, proof_check::StatedBranch& branch) {
    const StatedBoxes& boxes = branch.boxes;
    const Json& stated = row.at("special");
    std::size_t found = 0;
    for (std::size_t first = 1; first < boxes.size(); ++first) {
        if (boxes[first].decided || !boxes[first - 1].decided) continue;
        std::size_t last = first;
        while (last < boxes.size() && !boxes[last].decided) ++last;
        if (last == boxes.size()) break;
        if (boxes[first - 1].outside == boxes[last].outside) continue;
        if (found == stated.size()) throw BadInput("a special point of a branch is missing");
        read_special(stated[found], first, last, branch);
        ++found;
    }
    if (found != stated.size()) throw BadInput("a special point of a branch is in none of its boxes");
}

/// A branch, its boxes, and that what is said of them together is what they say.
proof_check::StatedBranch branch_in(const Json& document, const Json& row) {
    proof_check::StatedBranch branch;
    read_scene(document.at("scene"), branch.cycle);
    branch.cycle.uniform_lamina = document.at("inertia").get<std::string>() == "uniform lamina";
    const auto& along = document.at("along");
    if (along.size() != 1) throw BadInput("it runs along one parameter");
    branch.parameter = along.begin().key();
    const auto [low, high] = range_in(along.begin().value());
    const auto [from, to] = range_in(row.at("range"));
    branch.from = from;
    branch.to = to;
    if (!(low <= from && to <= high)) throw BadInput("a branch reaches beyond the range that was asked for");
    if (branch.parameter == "mu") branch.cycle.mu = to;
    for (const Json& letter : row.at("word")) {
        StatedStep step;
        step.vertex_step = whole(letter.at("vertex_step"));
        step.contact_mode = letter.at("contact_mode").get<std::string>();
        step.slip = whole(letter.at("slip"));
        branch.cycle.steps.push_back(step);
    }
    if (whole(row.at("period")) != static_cast<int>(branch.cycle.steps.size()))
        throw BadInput("a branch has another period than its word");
    for (const Json& part : row.at("boxes")) {
        proof_check::StatedBox box;
        const int running = whole(part.at("running"));
        if (running < 0) throw BadInput("a box has no running unknown");
        box.running = static_cast<std::size_t>(running);
        const auto [least, most] = range_in(part.at("range"));
        box.low = least;
        box.high = most;
        box.middle = part.at("middle").get<std::vector<double>>();
        box.within = part.at("within").get<double>();
        const Json& outside = part.at("outside");
        box.decided = !outside.is_null();
        if (box.decided) box.outside = whole(outside);
        if (box.decided) box.inside = whole(part.at("inside"));
        if (box.middle.empty()) throw BadInput("a box has no middle");
        branch.boxes.push_back(std::move(box));
    }
    require_stretches(row, branch.boxes);
    read_specials(row, branch);
    return branch;
}

void read_branches(const Json& document, StatedCertificate& stated) {
    std::size_t boxes = 0;
    for (const Json& row : document.at("branches")) {
        ++stated.orbits;
        boxes += row.at("boxes").size();
        if (row.at("proven").get<bool>()) stated.branches.push_back({stated.orbits, branch_in(document, row)});
    }
    if (static_cast<std::size_t>(whole(document.at("proven"))) != stated.branches.size())
        throw BadInput("the number of its proven branches is not that of its branches");
    if (static_cast<std::size_t>(whole(document.at("boxes"))) != boxes)
        throw BadInput("the number of its boxes is not that of its branches");
    if (stated.branches.empty()) throw BadInput("it states no branch as proven");
}

std::size_t number_of_set(const Json& number, std::size_t sets) {
    const int value = whole(number);
    if (value < 1 || static_cast<std::size_t>(value) > sets) throw BadInput("a covering is of a set that is not there");
    return static_cast<std::size_t>(value - 1);
}

proof_check::StatedChaos chaos_in(const Json& document) {
    proof_check::StatedChaos chaos;
    read_scene(document.at("scene"), chaos.scene);
    chaos.scene.uniform_lamina = document.at("inertia").get<std::string>() == "uniform lamina";
    const Json& result = document.at("chaos");
    if (!result.at("proven").get<bool>()) throw BadInput("it states no chaos as proven");
    chaos.growth = result.at("growth").get<double>();
    chaos.entropy = result.at("entropy").get<double>();
    if (const Json& level = document.at("J"); !level.is_null()) chaos.jacobi = level.get<double>();
    using Names = std::vector<std::string>;
    const Names wanted = chaos.scene.sides != 0 ? Names{"psi", "chi", "vn", "vt", "S"}
                         : chaos.scene.mu == 0  ? Names{"psi", "vt"}
                                                : Names{"psi", "vn", "vt", "S"};
    if (document.at("coordinates").get<Names>() != wanted)
        throw BadInput("its sets are in other coordinates than those of a proof of chaos");
    for (const Json& row : document.at("sets")) {
        proof_check::StatedSet set;
        set.centre = row.at("centre").get<std::vector<double>>();
        for (const Json& line : row.at("matrix")) {
            const auto entries = line.get<std::vector<double>>();
            if (entries.size() != set.centre.size()) throw BadInput("a set's matrix is not square");
            set.matrix.insert(set.matrix.end(), entries.begin(), entries.end());
        }
        set.weight = row.at("weight").get<double>();
        chaos.sets.push_back(std::move(set));
    }
    for (const Json& row : document.at("coverings")) {
        proof_check::StatedCovering covering;
        covering.from = number_of_set(row.at("from"), chaos.sets.size());
        covering.to = number_of_set(row.at("to"), chaos.sets.size());
        covering.vertex_step = whole(row.at("vertex_step"));
        covering.contact_mode = row.at("contact_mode").get<std::string>();
        covering.time = row.at("flight_time").get<double>();
        covering.image = row.at("image").get<std::array<double, 5>>();
        chaos.coverings.push_back(std::move(covering));
    }
    return chaos;
}

/// A document in which no object has a name twice, of which the library would keep the last.
Json parsed(const std::string& text) {
    std::vector<std::set<std::string>> names;
    const auto look = [&names](int, Json::parse_event_t event, const Json& value) {
        if (event == Json::parse_event_t::object_start) names.emplace_back();
        if (event == Json::parse_event_t::object_end) names.pop_back();
        if (event == Json::parse_event_t::key && !names.back().insert(value.get<std::string>()).second)
            throw BadInput(fmt::format("'{}' stands twice in one object", value.get<std::string>()));
        return true;
    };
    return Json::parse(text, look);
}

}  // namespace

std::string with_checksum(const std::string& open) {
    return open + tail_of(open);
}

std::unique_ptr<OutputFile> open_certificate(const std::string& name, bool force,
                                             const std::vector<std::string>& inputs) {
    if (name.empty()) return nullptr;
    require_no_input(name, inputs);
    std::error_code ignored;
    if (!force && std::filesystem::is_regular_file(name, ignored)) {
        constexpr std::size_t most = std::size_t{256} << 20U;
        bool own = false;
        try {
            own = looks_like_certificate(read_text("output", name, most));
        } catch (const BadInput&) {  // no text file: no certificate
        }
        if (!own)
            throw BadInput(
                fmt::format("output '{}' exists and is no certificate: name another file, or give --force", name));
    }
    try {
        return std::make_unique<OutputFile>(name, "certificate");
    } catch (const RecordError& error) {
        throw BadInput(error.what());
    }
}

void write_certificate(OutputFile& file, const std::string& text) {
    std::size_t written = 0;
    while (written < text.size()) {
        const auto now = ::write(file.descriptor(), text.data() + written, text.size() - written);
        if (now < 0 && errno == EINTR) continue;
        if (now < 0)
            throw std::system_error(errno, std::generic_category(), "cannot write '" + file.name().string() + "'");
        written += static_cast<std::size_t>(now);
    }
    file.commit();
}

bool looks_like_certificate(const std::string& text) {
    return text.find("\"certificate\": \"swirl\"") != std::string::npos;
}

StatedCertificate read_certificate(const std::string& file) {
    constexpr std::size_t most = std::size_t{256} << 20U;
    const std::string text = read_text("certificate", file, most);
    const auto refuse = [&](const std::string& why) {
        return BadInput(fmt::format("certificate '{}': {}", file, why));
    };
    if (!looks_like_certificate(text)) throw refuse("it is none; swirl certify --json or -o writes one");
    const auto end = text.rfind(before_checksum);
    if (end == std::string::npos || text.substr(end) != tail_of(std::string_view(text).substr(0, end)))
        throw refuse("it was changed after it was written: its checksum is another");
    StatedCertificate stated;
    try {
        const Json document = parsed(text);
        stated.interrupted = document.value("outcome", "completed") == "interrupted";
        stated.all = document.contains("all") && !document.at("all").is_null();
        if (document.contains("plane")) {
            stated.plane = plane_in(document);
            return stated;
        }
        if (document.contains("chaos")) {
            stated.chaos = chaos_in(document);
            return stated;
        }
        if (document.contains("branches")) {
            read_branches(document, stated);
            return stated;
        }
        for (const Json& orbit : document.at("orbits")) {
            ++stated.orbits;
            if (orbit.at("proven").get<bool>()) stated.proven.push_back({stated.orbits, cycle_in(document, orbit)});
        }
    } catch (const Json::exception& error) {
        throw refuse(error.what());
    } catch (const BadInput& error) {
        throw refuse(error.what());
    }
    return stated;
}

}  // namespace swirl::apps::certify
