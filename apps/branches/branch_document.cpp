#include "apps/branches/branches.hpp"
#include "apps/system/letter.hpp"

#include <cmath>

namespace swirl::apps {

void write_point(JsonWriter& json, std::string_view key, const Eigen::VectorXd& z) {
    constexpr const char* polygon[] = {"psi", "chi", "vn", "vt", "S"};
    constexpr const char* disk[] = {"psi", "vn", "vt", "S"};
    if (!key.empty()) json.key(key);
    json.begin_object();
    for (Eigen::Index i = 0; i < z.size(); ++i) json.member(z.size() == 4 ? disk[i] : polygon[i], z[i]);
    json.end_object();
}

void write_multipliers(JsonWriter& json, const std::vector<std::complex<double>>& multipliers) {
    json.key("multipliers");
    json.begin_array();
    for (const auto& m : multipliers) {
        json.begin_array();
        json.value(m.real());
        json.value(m.imag());
        json.end_array();
    }
    json.end_array();
}

void write_word(JsonWriter& json, std::string_view key, const std::vector<std::int64_t>& word) {
    json.key(key);
    json.begin_array();
    for (const std::int64_t letter : word) {
        const Letter l = letter_from(letter);
        json.begin_object();
        json.member("vertex_step", std::int64_t{l.vertex_step});
        json.member("contact_mode", name_of(l.mode));
        if (l.through_contact) json.member("through_contact", true);
        json.end_object();
    }
    json.end_array();
}

namespace {

void write_cycle(JsonWriter& json, const SceneBranches& scene, const analysis::BranchPoint& point) {
    json.member("parameter", analysis::parameter_of(scene.options, scene.map.has_parameter, point.at));
    write_point(json, "point", point.at.points.front());
    json.key("S");
    json.begin_array();
    for (const auto& z : point.at.points) json.value(z[z.size() - 1]);
    json.end_array();
    json.member("mean_S", point.mean);
    json.member("return_time", point.at.shooting.duration);
    write_multipliers(json, point.multipliers);
    json.member("index", std::int64_t{point.index});
    json.member("stability", analysis::name_of(point.stability));
    json.member("residual", point.at.shooting.residual());
}

void write_complex(JsonWriter& json, std::string_view key, std::complex<double> value) {
    json.key(key);
    json.begin_array();
    json.value(value.real());
    json.value(value.imag());
    json.end_array();
}

void write_special(JsonWriter& json, const SceneBranches& scene, const analysis::SpecialPoint& special) {
    json.begin_object();
    json.member("kind", kind_of(special));
    write_cycle(json, scene, special.cycle);
    if (!special.located) json.member("located", false);
    if (special.normal_form) {
        const auto& form = *special.normal_form;
        json.key("normal_form");
        json.begin_object();
        write_complex(json, "parameter", form.parameter);
        write_complex(json, "nonlinear", form.nonlinear);
        if (special.kind == analysis::SpecialKind::neimark_sacker) json.member("angle", form.angle);
        if (special.kind != analysis::SpecialKind::fold) json.member("supercritical", form.supercritical);
        json.end_object();
    }
    if (special.kind == analysis::SpecialKind::border) {
        write_word(json, "word_before", special.word_before);
        write_word(json, "word_after", special.word_after);
        json.member("goes_on", special.goes_on);
    }
    json.end_object();
}

}  // namespace

void write_branches(JsonWriter& json, const SceneBranches& scene, const std::vector<analysis::Branch>& branches) {
    json.key("branches");
    json.begin_array(JsonLayout::rows);
    for (const auto& branch : branches) {
        json.begin_object(JsonLayout::rows);
        json.member("period", static_cast<std::int64_t>(branch.period()));
        json.member("begins", analysis::name_of(branch.begin));
        json.member("ends", analysis::name_of(branch.end));
        if (branch.parent >= 0) {
            json.member("switched_from", std::int64_t{branch.parent});
            json.member("switched_at", std::int64_t{branch.parent_special});
        }
        write_word(json, "word", analysis::word_of(branch.points.front().at.shooting));
        json.key("points");
        json.begin_array(JsonLayout::rows);
        for (const auto& point : branch.points) {
            json.begin_object();
            write_cycle(json, scene, point);
            json.end_object();
        }
        json.end_array();
        json.key("special");
        json.begin_array(JsonLayout::rows);
        for (const auto& special : branch.special) write_special(json, scene, special);
        json.end_array();
        json.end_object();
    }
    json.end_array();
}

void print_branches(const SceneBranches& scene, const ParameterRange& along,
                    const std::vector<analysis::Branch>& branches) {
    for (std::size_t b = 0; b < branches.size(); ++b) {
        const auto& branch = branches[b];
        const auto value = [&](const analysis::BranchPoint& point) {
            return analysis::parameter_of(scene.options, scene.map.has_parameter, point.at);
        };
        fmt::print("branch {}, period {}: {} points, {} from {:.10g} ({}) to {:.10g} ({})", b, branch.period(),
                   branch.points.size(), along.name, value(branch.points.front()), analysis::name_of(branch.begin),
                   value(branch.points.back()), analysis::name_of(branch.end));
        if (branch.parent >= 0) fmt::print(", switched from branch {}", branch.parent);
        fmt::print("\n");
        for (const auto& special : branch.special) {
            const auto& c = special.cycle;
            fmt::print("  {:<15} {} = {:.12f}  S {:>15.12f}  |multiplier| {:.9f}", kind_of(special), along.name,
                       value(c), c.at.points.front().tail(1)[0], std::abs(c.multipliers.front()));
            if (!special.located) fmt::print("  not located: between two points of the branch");
            if (special.normal_form && special.kind != analysis::SpecialKind::fold)
                fmt::print("  {}", special.normal_form->supercritical ? "supercritical" : "subcritical");
            fmt::print("\n");
        }
    }
}

}  // namespace swirl::apps
