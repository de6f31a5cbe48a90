#pragma once

#include <httplib.h>

// A macro of <resolv.h>, which Eigen's headers do not stand.
#undef _res
