// SPDX-License-Identifier: MIT
//
// Runs Relief.usf in Unreal 5.2 or later. When the module starts, before shaders are compiled
// (LoadingPhase PostConfigInit), it maps the folder:
//
//     AddShaderSourceDirectoryMapping(TEXT("/Plugin/Scarp"), FolderOfTheShaders);
#include "GlobalShader.h"
#include "PipelineStateCache.h"
#include "ShaderParameterUtils.h"

#include <scarp.h>

class FScarpRelief : public FGlobalShader
{
    DECLARE_GLOBAL_SHADER(FScarpRelief);

  public:
    FScarpRelief() = default;

    FScarpRelief(const ShaderMetaType::CompiledShaderInitializerType &Initializer)
        : FGlobalShader(Initializer)
    {
        Plans.Bind(Initializer.ParameterMap, TEXT("ScarpPlans"), SPF_Mandatory);
        Result.Bind(Initializer.ParameterMap, TEXT("result"), SPF_Mandatory);
    }

    LAYOUT_FIELD(FShaderUniformBufferParameter, Plans);
    LAYOUT_FIELD(FShaderResourceParameter, Result);
};

IMPLEMENT_GLOBAL_SHADER(FScarpRelief, "/Plugin/Scarp/Relief.usf", "Relief", SF_Compute);

// On the render thread. Result: a structured buffer of 3 Count words.
void RunScarpRelief(FRHICommandList &Commands, const scarp_noise &Noise,
                    FRHIUnorderedAccessView *Result, uint32 Count)
{
    scarp_gpu_plan Plan;
    verify(scarp_gpu_plan_make(&Noise, 2, &Plan, nullptr) == SCARP_OK);
    const FRHIUniformBufferLayoutInitializer Layout(TEXT("ScarpPlans"), sizeof(Plan));
    const FUniformBufferLayoutRHIRef LayoutRef = RHICreateUniformBufferLayout(Layout);
    const FUniformBufferRHIRef Plans =
        RHICreateUniformBuffer(&Plan, LayoutRef, UniformBuffer_SingleFrame);

    TShaderMapRef<FScarpRelief> Shader(GetGlobalShaderMap(GMaxRHIFeatureLevel));
    FRHIComputeShader *const Compute = Shader.GetComputeShader();
    SetComputePipelineState(Commands, Compute);
    FRHIBatchedShaderParameters &Parameters = Commands.GetScratchShaderParameters();
    SetUniformBufferParameter(Parameters, Shader->Plans, Plans);
    SetUAVParameter(Parameters, Shader->Result, Result);
    Commands.SetBatchedShaderParameters(Compute, Parameters);
    Commands.DispatchComputeShader((Count + 63) / 64, 1, 1);
}
