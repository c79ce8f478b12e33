/* SPDX-License-Identifier: MIT
 *
 * What src/gpu/samples/Relief.cpp uses of Unreal, declared, so that the sample is compiled without
 * Unreal. Nothing here can run.
 */
#ifndef SCARP_TESTS_UNREAL_H
#define SCARP_TESTS_UNREAL_H

#include <cstdint>

typedef std::uint32_t uint32;

#define TEXT(text) u##text
#define verify(condition) static_cast<void>(condition)
#define DECLARE_GLOBAL_SHADER(name)                                                                \
  public:                                                                                          \
    typedef FShaderMetaType ShaderMetaType
#define LAYOUT_FIELD(type, name) type name
#define IMPLEMENT_GLOBAL_SHADER(type, path, function, frequency)                                   \
    static_assert(sizeof(type) != 0 && sizeof(path) > 1 && sizeof(function) > 1 && frequency >= 0, \
                  "a shader")

enum EShaderParameterFlags { SPF_Optional, SPF_Mandatory };
enum EShaderFrequency { SF_Compute };
enum EUniformBufferUsage { UniformBuffer_SingleDraw, UniformBuffer_SingleFrame };

struct FShaderParameterMap {
};
struct FShaderMetaType {
    struct CompiledShaderInitializerType {
        FShaderParameterMap ParameterMap;
    };
};
struct FShaderUniformBufferParameter {
    void Bind(const FShaderParameterMap &, const char16_t *, EShaderParameterFlags);
};
struct FShaderResourceParameter {
    void Bind(const FShaderParameterMap &, const char16_t *, EShaderParameterFlags);
};
class FGlobalShader
{
  public:
    FGlobalShader() = default;
    FGlobalShader(const FShaderMetaType::CompiledShaderInitializerType &);
};

struct FRHIComputeShader;
struct FRHIUnorderedAccessView;
struct FRHIUniformBuffer;
struct FRHIUniformBufferLayout;
struct FRHIBatchedShaderParameters;
struct FRHICommandList {
    FRHIBatchedShaderParameters &GetScratchShaderParameters();
    void SetBatchedShaderParameters(FRHIComputeShader *, FRHIBatchedShaderParameters &);
    void DispatchComputeShader(uint32, uint32, uint32);
};
template <typename T> struct TRefCountPtr {
    operator T *() const;
};
typedef TRefCountPtr<FRHIUniformBuffer> FUniformBufferRHIRef;
typedef TRefCountPtr<const FRHIUniformBufferLayout> FUniformBufferLayoutRHIRef;
struct FRHIUniformBufferLayoutInitializer {
    FRHIUniformBufferLayoutInitializer(const char16_t *, uint32);
};
FUniformBufferLayoutRHIRef RHICreateUniformBufferLayout(const FRHIUniformBufferLayoutInitializer &);
FUniformBufferRHIRef RHICreateUniformBuffer(const void *, const FRHIUniformBufferLayout *,
                                            EUniformBufferUsage);
void SetComputePipelineState(FRHICommandList &, FRHIComputeShader *);
void SetUniformBufferParameter(FRHIBatchedShaderParameters &, const FShaderUniformBufferParameter &,
                               FRHIUniformBuffer *);
void SetUAVParameter(FRHIBatchedShaderParameters &, const FShaderResourceParameter &,
                     FRHIUnorderedAccessView *);

struct FGlobalShaderMap;
enum ERHIFeatureLevel { SM5 };
extern ERHIFeatureLevel GMaxRHIFeatureLevel;
FGlobalShaderMap *GetGlobalShaderMap(ERHIFeatureLevel);
template <typename T> struct TShaderMapRef {
    explicit TShaderMapRef(FGlobalShaderMap *);
    T *operator->() const;
    FRHIComputeShader *GetComputeShader() const;
};

#endif
