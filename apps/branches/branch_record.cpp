#include "apps/branches/branches.hpp"
#include "apps/system/letter.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace swirl::apps {

namespace {

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

/// A coordinate of each point of a cycle, NaN beyond its period.
void append_phases(std::vector<double>& values, const analysis::CurvePoint& at, std::size_t longest,
                   const std::string& observable) {
    for (std::size_t i = 0; i < longest; ++i)
        values.push_back(i < at.points.size() ? at.points[i][place_of(observable, at.points[i].size())] : nothing);
}

/// A word as text: vertex step and contact mode of each letter, "+1 sliding, +2 c-sticking"; empty if the map ends.
std::string text_of(const std::vector<std::int64_t>& word) {
    std::string text;
    for (const std::int64_t letter : word) {
        const Letter l = letter_from(letter);
        text += fmt::format("{}{:+d} {}{}", text.empty() ? "" : ", ", l.vertex_step, name_of(l.mode),
                            l.through_contact ? " through contact" : "");
    }
    return text;
}

struct Columns {
    std::vector<std::int64_t> branch, period, stable, index;
    std::vector<double> parameter, mean, largest, spins, values, time, residual;

    void add(const SceneBranches& scene, std::size_t b, const analysis::BranchPoint& point, std::size_t longest,
             const std::string& observable) {
        branch.push_back(static_cast<std::int64_t>(b));
        period.push_back(static_cast<std::int64_t>(point.at.points.size()));
        stable.push_back(point.stability == analysis::Stability::unstable ? 0 : 1);
        index.push_back(point.index);
        parameter.push_back(analysis::parameter_of(scene.options, scene.map.has_parameter, point.at));
        mean.push_back(point.mean);
        largest.push_back(std::abs(point.multipliers.front()));
        time.push_back(point.at.shooting.duration);
        residual.push_back(point.at.shooting.residual());
        append_phases(spins, point.at, longest, "S");
        append_phases(values, point.at, longest, observable);
    }

    void write(const RecordGroup& group, const std::string& rows, const std::string& observable) const {
        const std::vector<std::string> by_row{rows}, by_phase{rows, "phase"};
        group.write<std::int64_t>("branch", by_row, branch, {"1", "number of the branch", {}});
        group.write<std::int64_t>("period", by_row, period, {"1", "k", {}});
        group.write<std::int64_t>("stable", by_row, stable, {"1", "1: no multiplier outside the unit circle", {}});
        group.write<std::int64_t>("index", by_row, index, {"1", "multipliers outside the unit circle", {}});
        group.write<double>("parameter", by_row, parameter,
                            {"1", "value of the parameter named by settings: along", {}});
        group.write<double>("mean_S", by_row, mean, {"omega_s", "time mean of S", {}});
        group.write<double>("return_time", by_row, time, {"1/omega_s", "sum of the flights", {}});
        group.write<double>("largest_multiplier", by_row, largest, {"1", "modulus", {}});
        group.write<double>("residual", by_row, residual, {"1", "largest |F(z_i) - z_(i+1)|", {}});
        group.write<double>("S", by_phase, spins, {"omega_s", "S after each impact of the cycle; NaN beyond it", {}});
        if (observable != "S") group.write<double>("value", by_phase, values, {"1", "observable " + observable, {}});
    }
};

/// What special points have beyond a cycle's columns. NaN: no normal form.
struct SpecialColumns {
    std::vector<std::string> kind, word_before, word_after;
    std::vector<std::int64_t> located, goes_on, supercritical;
    std::vector<double> parameter_re, parameter_im, nonlinear_re, nonlinear_im, angle;

    void add(const analysis::SpecialPoint& s) {
        const bool border = s.kind == analysis::SpecialKind::border;
        kind.push_back(kind_of(s));
        word_before.push_back(border ? text_of(s.word_before) : "");
        word_after.push_back(border ? text_of(s.word_after) : "");
        located.push_back(s.located ? 1 : 0);
        goes_on.push_back(s.goes_on ? 1 : 0);
        const auto form =
            s.normal_form.value_or(analysis::NormalForm{{nothing, nothing}, {nothing, nothing}, nothing, false});
        const bool tells = s.normal_form && s.kind != analysis::SpecialKind::fold;
        supercritical.push_back(tells ? (form.supercritical ? 1 : 0) : -1);
        parameter_re.push_back(form.parameter.real());
        parameter_im.push_back(form.parameter.imag());
        nonlinear_re.push_back(form.nonlinear.real());
        nonlinear_im.push_back(form.nonlinear.imag());
        angle.push_back(s.kind == analysis::SpecialKind::neimark_sacker ? form.angle : nothing);
    }

    void write(const RecordGroup& group) const {
        const std::vector<std::string> rows{"special_point"};
        group.write_strings("kind", rows, kind);
        group.write_strings("word_before", rows, word_before);
        group.write_strings("word_after", rows, word_after);
        group.write<std::int64_t>("located", rows, located, {"1", "0: known only to lie between two points", {}});
        group.write<std::int64_t>("goes_on", rows, goes_on, {"1", "0: no cycle was found behind the border", {}});
        group.write<std::int64_t>("supercritical", rows, supercritical, {"1", "1 yes, 0 no, -1 does not apply", {}});
        group.write<double>("form_parameter_re", rows, parameter_re, {"1", "normal form: a", {}});
        group.write<double>("form_parameter_im", rows, parameter_im, {"1", "normal form: a", {}});
        group.write<double>("form_nonlinear_re", rows, nonlinear_re, {"1", "normal form: b", {}});
        group.write<double>("form_nonlinear_im", rows, nonlinear_im, {"1", "normal form: b", {}});
        group.write<double>("form_angle", rows, angle, {"rad", "normal form: theta", {}});
    }
};

void write_ends(const RecordGroup& root, const std::vector<analysis::Branch>& branches) {
    std::vector<std::int64_t> period, parent, parent_special;
    std::vector<std::string> begins, ends, word;
    for (const auto& branch : branches) {
        period.push_back(static_cast<std::int64_t>(branch.period()));
        parent.push_back(branch.parent);
        parent_special.push_back(branch.parent_special);
        begins.emplace_back(analysis::name_of(branch.begin));
        ends.emplace_back(analysis::name_of(branch.end));
        word.push_back(text_of(analysis::word_of(branch.points.front().at.shooting)));
    }
    const RecordGroup group = root.group("branch_ends");
    group.dimension("branch", branches.size());
    group.write<std::int64_t>("period", {"branch"}, period, {"1", "k", {}});
    group.write_strings("begins", {"branch"}, begins);
    group.write_strings("ends", {"branch"}, ends);
    group.write_strings("word", {"branch"}, word);
    group.write<std::int64_t>("switched_from", {"branch"}, parent, {"1", "a branch; -1: none", {}});
    group.write<std::int64_t>("switched_at", {"branch"}, parent_special,
                              {"1", "that branch's special point; -1: none", {}});
}

}  // namespace

Eigen::Index place_of(const std::string& observable, Eigen::Index size) {
    constexpr const char* polygon[] = {"psi", "chi", "vn", "vt", "S"};
    constexpr const char* disk[] = {"psi", "vn", "vt", "S"};
    for (Eigen::Index i = 0; i < size; ++i)
        if (observable == (size == 4 ? disk[i] : polygon[i])) return i;
    return size - 1;
}

void write_branches(const RecordGroup& root, const SceneBranches& scene, const std::vector<analysis::Branch>& branches,
                    const std::string& observable) {
    std::size_t longest = 1;
    Columns points, special;
    SpecialColumns forms;
    for (const auto& branch : branches) longest = std::max(longest, branch.period());
    for (std::size_t b = 0; b < branches.size(); ++b) {
        for (const auto& point : branches[b].points) points.add(scene, b, point, longest, observable);
        for (const auto& s : branches[b].special) {
            special.add(scene, b, s.cycle, longest, observable);
            forms.add(s);
        }
    }
    if (!points.branch.empty()) {
        const RecordGroup group = root.group("branches");
        group.dimension("point", points.branch.size());
        group.dimension("phase", longest);
        points.write(group, "point", observable);
        write_ends(root, branches);
    }
    if (!special.branch.empty()) {
        const RecordGroup group = root.group("special");
        group.dimension("special_point", special.branch.size());
        group.dimension("phase", longest);
        special.write(group, "special_point", observable);
        forms.write(group);
    }
}

}  // namespace swirl::apps
