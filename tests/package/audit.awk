# SPDX-License-Identifier: MIT
# Reads disassembly (objdump -d --no-show-raw-insn, GNU's or LLVM's) and reports instructions that
# break the promise of equal bits, or that a processor may lack when the code is reached. Variables:
# processor; files: 1 if objects keep to their own instruction set (rules by file name apply);
# exact: a pattern of objects where vf_exact_fma may have made packed fused instructions.

/file format/ {
    object = $0 # a path, which may have spaces
    sub(/:[ \t]*file format.*/, "", object)
    sub(/.*\//, "", object)
    next
}

/^[0-9a-f]+ <.*>:/ {
    routine = $2
    next
}

/^ *[0-9a-f]+:/ {
    line = $0
    sub(/^ *[0-9a-f]+:[ \t]*/, "", line)
    sub(/[<#].*/, "", line) # names and comments
    count = split(line, word)
    i = 1
    while (i < count && word[i] ~ /^(lock|rep[a-z]*|data16|[c-gs]s|notrack|bnd|addr32|rex.*|\{.*)$/)
        i++
    if (word[i] != "") {
        instructions++
        check(word[i], line)
    }
}

function report(rule)
{
    reports++
    if (++reported[object, rule] <= 3)
        printf "%s %s %s: %s\n", object, routine, rule, line
}

# Whether it multiplies vectors of floats.
function packed(name, line)
{
    return name ~ /^vfn?m(add|sub)(132|213|231)ps$/ || (name ~ /^fml[as]$/ && line ~ /v[0-9]+[.]4s/) ||
        name ~ /^fml[as][.]4s$/
}

function check(name, line)
{
    if (name ~ /^v[0-9]*fn?m(add|sub)/ || name ~ /^fn?m(add|sub|la|ls|ad|sb)/ ||
        name ~ /^([vw]f)?n?m[as][sed]br?$/) {
        if (exact == "" || object !~ exact || !packed(name, line))
            report("fused multiply-add")
    }
    if (name ~ /^v?r(cp|sqrt)(14|28)?[sp][sdh]$/ || name ~ /^[fu]r(ecp|sqrt)[esx]$/)
        report("estimate")
    if (!files || processor !~ /^(x86_64|AMD64)$/)
        return
    avx = name ~ /^(v|k(mov|x?n?or|andn?|add|not|o?r?test|shift|unpck))/
    if (avx && object !~ /kernels_avx/)
        report("AVX outside its kernels")
    if (object ~ /kernels_avx2/ && line ~ /%(zmm|k[0-7]|[xy]mm(1[6-9]|[23][0-9]))/)
        report("AVX-512 in the AVX2 kernels")
    if (name ~ /^(andn|bextr|bls(i|r|msk)|bzhi|mulx|pdep|pext|rorx|sarx|shlx|shrx)[lq]?$/)
        report("BMI, which is not asked of the processor")
    if ((object !~ /kernels_/ || object ~ /kernels_generic/) &&
        name ~ /^(pmulld|round[sp][sd]|p?blendv|ptest|pmov[sz]x|pshufb)/)
        report("SSE4.1 outside its kernels")
    if (object ~ /kernels_sse41/ && name ~ /^(pcmpgtq|popcnt|crc32)/)
        report("SSE4.2 in the SSE4.1 kernels")
}

END {
    printf "%d instructions, %d reports\n", instructions, reports
    exit reports > 0 || instructions < 1
}
