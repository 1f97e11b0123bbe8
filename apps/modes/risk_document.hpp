// The risk at which chaos is called before the limits: its flag, and what a document, a record and people are told.
#pragma once

#include "apps/command_line/documents.hpp"
#include "apps/command_line/flags.hpp"
#include "apps/record/record_reader.hpp"
#include "apps/studies/modes/early_chaos.hpp"

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

/// Member `risk_evidence`, a list: runs, impacts, least_exponent, followed, judged, changed, bound.
void write_risk(JsonWriter& json, const std::vector<RiskEvidence>& evidence);
/// The same as a group of this name, with what is assumed; nothing where there is none.
void write_risk(const RecordGroup& root, const std::vector<RiskEvidence>& evidence);
/// From a record; none where it has no such group. @throws RecordError
std::vector<RiskEvidence> read_risk(const RecordReader& record);

/// A line for people.
std::string in_words(const RiskEvidence& evidence);

}  // namespace swirl::apps
