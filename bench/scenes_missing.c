/* scenes_missing.c: `sgfit bench --scenes` where the renderer was not built. */
#include "base/options.h"
#include "base/text.h"
#include "scenes_command.h"

int scenes_command(const scenes_request *request)
{
    (void)request;
    base_error("bench: --scenes needs Vulkan, shaderc and Assimp, which were not there when sgfit "
               "was built");
    return BASE_FAILED;
}
