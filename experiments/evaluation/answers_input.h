#pragma once

#include "shapegauge/experiments/evaluation/evaluation_input.h"
#include "shapegauge/experiments/evaluation/labelled_task.h"
#include "shapegauge/experiments/evaluation/ranked_answers.h"

namespace shapegauge {

/// Ranked answers as an evaluation: a row a query, a column a model, in descending order of their ids, which is how
/// trec_eval breaks ties; NaN where an answer does not have the model. With classes, queries without an answer are left
/// out, with a note. Throws InputError where a model is in no class or a query is none.
EvaluationInput input_of_answers(const RankedAnswers& answers, const ClassifiedModels& classified);

/// The same with judgements: a query's relevant models are those that are judged so, found or not. A query is never
/// taken for one of the models. Queries without judgements and judged queries without an answer are left out, with a
/// note.
EvaluationInput input_of_answers(const RankedAnswers& answers, const Judgements& judgements);

/// The task of a matrix of those models under judgements, without its distances. A row's own column is the model of its
/// id, where there is one. Throws InputError where a judged query or model is not in the matrix; `source` names the
/// judgements.
EvaluationInput input_of_judgements(const MatrixModels& models, const Judgements& judgements,
                                    const std::string& source);

}  // namespace shapegauge
