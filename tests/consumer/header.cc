#include <sg.h>

extern "C" int header_compiles_as_cxx(void)
{
    return sg_status_string(SG_DOMAIN) ? 0 : 1;
}
