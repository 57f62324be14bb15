#include "sg.h"

const char *sg_status_string(sg_status status)
{
    switch (status) {
    case SG_OK:
        return "success";
    case SG_DOMAIN:
        return "an argument lies outside the domain";
    case SG_NO_CONVERGENCE:
        return "an iteration ended without reaching its tolerance";
    case SG_UNKNOWN:
        return "no such method, route or form";
    }
    return "unknown status";
}
