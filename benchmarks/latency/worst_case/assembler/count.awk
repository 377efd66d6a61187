# x86-64 assembly in which every block adds the number of its instructions to counted_instructions. The five
# instructions that do so are not counted, change no flag and no register, and leave the stack alone, so that all
# others stay what the compiler made of them. Of functions that were compiled elsewhere:
#   - those that a control cycle calls have the figure that callgrind counts (glibc 2.36, a processor with FMA);
#   - each other call is added to uncounted_calls.

function add(number, where) {
  print "\tmovq %rax, counted_saved(%rip)\n\tmovq " where "(%rip), %rax\n\tleaq " number "(%rax), %rax"
  print "\tmovq %rax, " where "(%rip)\n\tmovq counted_saved(%rip), %rax"
}
function end_block() {
  if (pending > 0) add(pending, "counted_instructions")
  pending = 0
}

BEGIN {
  of["fma"] = 3
  of["expm1"] = 40
  of["__popcountdi2"] = 22
  of["sqrt"] = 9  # of what is not positive
}

/^\t\.(cfi_endproc|section|text|data|bss)/ { pending = 0 }
/^[^\t #].*:/ { end_block() }
/^\t[a-z]/ {
  ++pending
  if ($1 ~ /^(call|jmp)/ && $2 !~ /^(_Z|\*|\.L|counted)/) {
    name = $2
    sub(/@.*/, "", name)
    if (name in of) pending += of[name]
    else add(1, "uncounted_calls")
  }
}
/^\t((notrack|rep|bnd) )?(j|ret)/ { end_block() }
{ print }
