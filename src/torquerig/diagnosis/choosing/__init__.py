"""Which effects complete a model.

trial        a hypothesis fitted, and its price       screening    which are fitted with all numbers free
search       the hypotheses fitted, best first        gap_trial    a gap, which no linear twin has
explained    what of a mismatch went                  convincing   when an effect may be named
equivalence  rivals that cannot be told apart         revising     each looked back at beside the others
identifying  the numbers that identify an effect      confidence   how sure a finding is
chain        one after the other                  beginning_again  once more, begun elsewhere
set_aside    what was not fitted, and why          around_gap   a gap told again beside a further effect
secondary    what is small beside a large effect  numbers_held  before all is withdrawn
opened_gap   where flanks may part                 gap_width    how wide the gap is
gap_fits     a model fitted around a gap           chattering   a gap that its chatter tells
beside_gaps  what is no detail of a gap, and what is likelier than one
one_of_many  a line beside others of its kind that stay
beside_ringing  what may be a detail of how impacts ring
possible     whether its numbers are such as can be, and as rigs have
"""
