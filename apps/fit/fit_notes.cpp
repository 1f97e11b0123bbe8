#include "apps/fit/fit_notes.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <cstddef>

namespace swirl::apps::fit {

namespace {

/// Laws to which the misfits are this much wider than the noise leave something out.
constexpr double wide_scatter = 1.5;

std::string sign_note(const analysis::MomentumSigns& signs, bool by_rows) {
    const char* const spin = "the spin's sign is turned (it was measured clockwise, or y points down)";
    const std::string tangent =
        fmt::format("v_x is mirrored, or, the same to the impacts, {}",
                    by_rows ? "d3 has the other sign" : "r_y has the other sign, or S and r_x have");
    const std::string cure = signs.spin > 0      ? tangent
                             : signs.tangent > 0 ? spin
                                                 : fmt::format("{}, and {}", spin, tangent);
    const auto coefficient = [&signs](std::size_t j) {
        if (std::isnan(signs.coefficients[j])) return std::string("none (0 in all rows)");
        return fmt::format("{:.4g} +- {:.2g}", signs.coefficients[j], signs.errors[j]);
    };
    return fmt::format(
        "momentum contradicts the signs as given: k dS = r_x dv_y - r_y dv_x has the coefficients {} and {}, and both "
        "are 1/k. What cures it, and what the fit goes on with: {}",
        coefficient(0), coefficient(1), cure);
}

void note_law(std::vector<std::string>& notes, const analysis::ImpactFit& fit) {
    std::vector<std::string> alike;
    for (std::size_t i = 0; i < fit.laws.size(); ++i)
        if (i != fit.best && !(fit.laws[i].worse_by > analysis::sure_law)) alike.push_back(fit.laws[i].name);
    if (!alike.empty())
        notes.push_back(
            fmt::format("these impacts do not tell {} from {}: laws differ only where friction acts beside the centre",
                        fit.laws[fit.best].name, fmt::join(alike, " and ")));
}

void note_constancy(std::vector<std::string>& notes, const analysis::ImpactFit& fit) {
    for (const analysis::ConstancyTest& test : fit.constancy)
        if (!test.constant)
            notes.push_back(fmt::format("{} is not constant: it {} by {:.3g} +- {:.1g} per unit of {} speed",
                                        test.parameter, test.slope > 0 ? "rises" : "falls", std::abs(test.slope),
                                        test.error, test.speed));
}

}  // namespace

std::string risen_energy(const analysis::ImpactFit& fit) {
    return fmt::format(
        "energy in the wall's frame surely rises at {} of {} impacts, in the median {:.3g} times, and no wall adds "
        "any: "
        "what is called before was after, or time runs backwards",
        fit.energy.rises, fit.impacts.size(), fit.energy.ratio);
}

bool contradicts_momentum(const analysis::ImpactFit& fit, bool stated) {
    const double k = fit.inertia.value;
    if (k >= fit.balance.low && !(k > fit.balance.high)) return false;
    if (!stated) return true;
    constexpr double wider = 1.1;
    const std::vector<double> once(fit.impacts.size(), 1.0);
    return analysis::known_inertia(fit.impacts, once, k).scale >
           wider * analysis::known_inertia(fit.impacts, once, fit.balance.value).scale;
}

std::vector<std::string> notes_of(const analysis::ImpactFit& fit, const ImpactTable& table) {
    std::vector<std::string> notes;
    if (fit.signs.spin < 0 || fit.signs.tangent < 0) notes.push_back(sign_note(fit.signs, table.by_rows));
    const double k = fit.inertia.value;
    if (k == fit.inertia.low && k == fit.inertia.high && contradicts_momentum(fit, table.has_errors))
        notes.push_back(fmt::format("momentum contradicts inertia = {:g}: it alone gives {:.4g} [{:.4g}, {:.4g}]", k,
                                    fit.balance.value, fit.balance.low, fit.balance.high));
    if (std::isnan(fit.inertia.high) && !std::isnan(fit.inertia.low))
        notes.push_back(fmt::format(
            "I/m can hardly be told: impacts change the spin by little more than its noise, and any I/m above "
            "{:.4g} explains some resamples; give it",
            fit.inertia.low));
    if (fit.friction_open)
        notes.push_back(fmt::format(
            "friction can't be told: the contacts stick, and any mu above {:.3g} predicts the same", fit.friction.low));
    note_law(notes, fit);
    if (fit.scatter > wide_scatter)
        notes.push_back(fmt::format(
            "the impacts scatter about the law {:.2g} times as widely as momentum says that they were measured",
            fit.scatter));
    note_constancy(notes, fit);
    if (fit.left_out > 0)
        notes.push_back(fmt::format("{} a number a million times the others', and {} left out",
                                    fit.left_out == 1 ? "1 row has" : fmt::format("{} rows have", fit.left_out),
                                    fit.left_out == 1 ? "is" : "are"));
    if (table.missing > 0) notes.push_back(fmt::format("{} rows lack a value and are left out", table.missing));
    return notes;
}

}  // namespace swirl::apps::fit
