#include "apps/fit/fit_document.hpp"

#include "apps/output/wrapped.hpp"
#include "apps/output/write_table.hpp"

#include <fmt/format.h>

#include <cmath>
#include <cstdint>

namespace swirl::apps::fit {

namespace {

using analysis::ConstancyTest;
using analysis::FittedLaw;
using analysis::FittedNumber;
using analysis::ImpactFit;

struct ImpactRow {
    analysis::ImpactResidual residual;
    double held_out;
};

struct ProfilePoint {
    double value, deviance;
};

Settings number_of(const FittedNumber& number) {
    return {{"value", number.value}, {"low", number.low}, {"high", number.high}};
}

Table<FittedLaw> law_table() {
    using F = Field<FittedLaw>;
    const auto of = [](double analysis::LawParameters::*member) {
        return [member](const FittedLaw& law) { return law.parameters.*member; };
    };
    return {{"law"},
            {F{"law", &FittedLaw::name, "", "name"}.coordinate().shown("  law", "  {:<10}"),
             F{"restitution", of(&analysis::LawParameters::restitution), "1", "e"}.shown("restitution", " {:>12.5g}"),
             F{"friction", of(&analysis::LawParameters::friction), "1", "mu"}.shown("friction", " {:>10.5g}"),
             F{"loss", &FittedLaw::loss, "1", "half the summed biweight loss"}.shown("loss", " {:>12.6g}"),
             F{"worse_by", &FittedLaw::worse_by, "1", "standard errors of the loss beyond the best law's"}.shown(
                 "worse by", " {:>9.3g}")}};
}

Table<ConstancyTest> constancy_table() {
    using F = Field<ConstancyTest>;
    return {{"test"},
            {F{"parameter", &ConstancyTest::parameter, "", "restitution or friction"},
             F{"speed", &ConstancyTest::speed, "", "of the contact: approach or slip"},
             F{"slope", &ConstancyTest::slope, "1", "change of the parameter per unit of speed"},
             F{"error", &ConstancyTest::error, "1", "its standard error"},
             F{"constant", &ConstancyTest::constant, "1", "the slope is within 2.5 of them"}}};
}

Table<ImpactRow> impact_table() {
    using F = Field<ImpactRow>;
    const auto of = [](double analysis::ImpactResidual::*member) {
        return [member](const ImpactRow& row) { return row.residual.*member; };
    };
    using R = analysis::ImpactResidual;
    return {{"impact"},
            {F{"approach_speed", of(&R::approach_speed), "1", "of the contact before"},
             F{"slip_speed", of(&R::slip_speed), "1", "of the contact before"},
             F{"misfit", of(&R::misfit), "1", "distance from the law, in units of the scatter"},
             F{"weight", of(&R::weight), "1", "0 of an outlier, 1 of a perfect fit"},
             F{"restitution", of(&R::restitution), "1", "e that this impact alone asks for, less the fit's"},
             F{"restitution_information", of(&R::restitution_information), "1", "one over its variance"},
             F{"friction", of(&R::friction), "1", "mu that this impact alone asks for, less the fit's"},
             F{"friction_information", of(&R::friction_information), "1", "one over its variance"},
             F{"held_out", &ImpactRow::held_out, "1",
               "squared distance of its prediction by a fit without it, in units of the noise"}}};
}

Table<ProfilePoint> profile_table() {
    return {{"point"},
            {{"value", &ProfilePoint::value, "1", "of the parameter"},
             {"deviance", &ProfilePoint::deviance, "1", "2 (loss - least loss)"}}};
}

std::vector<ImpactRow> impact_rows(const ImpactFit& fit) {
    std::vector<ImpactRow> rows;
    for (std::size_t i = 0; i < fit.residuals.size(); ++i) rows.push_back({fit.residuals[i], fit.held_out[i]});
    return rows;
}

std::vector<ProfilePoint> points_of(const analysis::LossProfile& profile) {
    std::vector<ProfilePoint> points;
    for (std::size_t i = 0; i < profile.values.size(); ++i) points.push_back({profile.values[i], profile.deviances[i]});
    return points;
}

/// What is one number, truth or word.
Settings result_of(const FitReport& report) {
    const ImpactFit& fit = report.fit;
    return {{"law", fit.laws[fit.best].name},
            {"law_decided", fit.law_decided},
            {"sign_of_spin", std::int64_t{fit.signs.spin}},
            {"sign_of_tangent", std::int64_t{fit.signs.tangent}},
            {"impacts", static_cast<std::int64_t>(fit.impacts.size())},
            {"left_out", static_cast<std::int64_t>(report.left_out)},
            {"predicted", fit.predicted},
            {"velocity_noise", fit.velocity_noise},
            {"spin_noise", fit.spin_noise},
            {"scatter", fit.scatter},
            {"energy_ratio", fit.energy.ratio},
            {"energy_rises", static_cast<std::int64_t>(fit.energy.rises)}};
}

/// What momentum alone says.
Settings momentum_of(const ImpactFit& fit) {
    return {{"coefficients", std::vector<double>(fit.signs.coefficients.begin(), fit.signs.coefficients.end())},
            {"errors", std::vector<double>(fit.signs.errors.begin(), fit.signs.errors.end())},
            {"inertia", fit.balance.value},
            {"low", fit.balance.low},
            {"high", fit.balance.high}};
}

std::string interval_in_words(const FittedNumber& number) {
    if (std::isnan(number.value)) return fmt::format("above {:.4g}", number.low);
    if (std::isnan(number.high) && !std::isnan(number.low))
        return fmt::format("{:<12.5g} [{:.5g}, no upper end]", number.value, number.low);
    return fmt::format("{:<12.5g} [{:.5g}, {:.5g}]", number.value, number.low, number.high);
}

/// Of falls beside that of a uniform body, and of a given one beside what momentum alone tells.
std::string inertia_in_words(const FitReport& report) {
    const ImpactFit& fit = report.fit;
    if (!report.inertia_given)
        return interval_in_words(fit.inertia) +
               (report.falls ? fmt::format(" by momentum; {:.5g} of a uniform body", report.falls->source.body.inertia)
                             : "");
    std::string given = fmt::format("{:<12.6g} given", fit.inertia.value);
    if (report.falls) given += "; momentum alone tells " + interval_in_words(fit.balance);
    return given;
}

}  // namespace

void write_json(const FitReport& report) {
    const ImpactFit& fit = report.fit;
    print_document([&](JsonWriter& json) {
        write_json(json, "restitution", number_of(fit.restitution));
        write_json(json, "friction", number_of(fit.friction));
        write_json(json, "inertia", number_of(fit.inertia));
        write_members(json, result_of(report));
        write_json(json, "momentum", momentum_of(fit));
        write_json(json, "laws", law_table(), fit.laws);
        write_json(json, "constancy", constancy_table(), fit.constancy);
        if (report.film) write_json(json, *report.film);
        if (report.falls) write_json(json, *report.falls);
        json.list("notes", report.notes, JsonLayout::rows);
        write_json(json, "settings", report.settings);
    });
}

void write_record(const RecordGroup& root, const FitReport& report) {
    const ImpactFit& fit = report.fit;
    const RecordGroup group = root.group("fit");
    write_attributes(group, result_of(report));
    write_attributes(group.group("restitution"), number_of(fit.restitution));
    write_attributes(group.group("friction"), number_of(fit.friction));
    write_attributes(group.group("inertia"), number_of(fit.inertia));
    write_attributes(group.group("momentum"), momentum_of(fit));
    if (!report.notes.empty()) write_attributes(group, {{"notes", report.notes}});
    write_attributes(root.group("settings"), report.settings);
    write_record(root.group("laws"), law_table(), fit.laws);
    write_record(root.group("constancy"), constancy_table(), fit.constancy);
    write_record(root.group("impacts"), impact_table(), impact_rows(fit));
    write_record(root.group("restitution_profile"), profile_table(), points_of(fit.restitution_profile));
    write_record(root.group("friction_profile"), profile_table(), points_of(fit.friction_profile));
    if (report.film) write_record(root, *report.film);
    if (report.falls) write_record(root, *report.falls);
}

void print_report(const FitReport& report) {
    const ImpactFit& fit = report.fit;
    const std::string left_out =
        report.left_out > 0 ? fmt::format(" of {}, {} left out", report.rows, report.left_out) : "";
    if (report.film)
        print_film(*report.film);
    else if (report.falls)
        print_falls(*report.falls);
    else
        fmt::print("{} impacts{}\n", fit.impacts.size(), left_out);
    fmt::print("  restitution e   {}\n  friction mu     {}\n  inertia I/m     {}\n", interval_in_words(fit.restitution),
               interval_in_words(fit.friction), inertia_in_words(report));
    fmt::print("  law             {}{}\n", fit.laws[fit.best].name, fit.law_decided ? "" : ", not decided");
    fmt::print("  noise           {:.3g} of a velocity, {:.3g} of a spin; scatter about the law {:.3g} times that\n",
               fit.velocity_noise, fit.spin_noise, fit.scatter);
    fmt::print("  predicted       {:.1f} % of held-out impacts within the noise\n", 100 * fit.predicted);
    print_table(law_table(), fit.laws);
    for (const std::string& note : report.notes) fmt::print("{}\n", wrapped("note: " + note, 2));
    if (report.falls) print_subsets(*report.falls);
    if (report.film) print_commands(*report.film);
}

}  // namespace swirl::apps::fit
