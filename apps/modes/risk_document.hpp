// The risk at which chaos is called before the limits: its flag, and what a document, a record and people are told.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/studies/modes/early_chaos.hpp"

#include <cstdint>
#include <string>
#include <vector>

namespace swirl::apps {

using studies::RiskEvidence;

/// --risk P: 0 or more, below 1; --error E: above 0. They keep what is not given.
void add_risk_flags(Flags& command, double& risk, double& error);

/// Where all impacts are asked for none can be left out, and only means of runs that are called early are followed on.
/// @throws BadInput
void check_risk(double risk, double error, bool exhaustive);
/// Adds the settings `risk` and `error` where they are given.
void add_risk_settings(Settings& settings, double risk, double error);
/// The setting `error`; infinite where there is none.
double error_in(const Settings& settings);

/// Member `risk_evidence`, a list: runs, impacts, least_exponent, least_runs, drawn, followed, judged, changed, bound,
/// means_followed.
void write_risk(JsonWriter& json, const std::vector<RiskEvidence>& evidence);
/// The same as a group of this name, with what is assumed; nothing where there is none.
void write_risk(const RecordGroup& root, const std::vector<RiskEvidence>& evidence);
/// From a record; none where it has no such group. @throws RecordError
std::vector<RiskEvidence> read_risk(const RecordReader& record);

/// A line for people: what is called, or why nothing is, and what --error did (infinite: it was not given).
std::string in_words(const RiskEvidence& evidence, double error);
/// Of one run alone, whose look is `look` (look_of_one; 0: none): that nothing came of --risk; else empty.
std::string risk_of_one_in_words(double risk, std::int64_t look, double error);

}  // namespace swirl::apps
