#include "shapegauge/retrieval/histogram.h"
