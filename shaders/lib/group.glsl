// Workgroups: their number in a dispatch, and sums over their invocations.

// Numbers the workgroups of a dispatch, which are laid out in rows (see dispatchSize). The last row may hold surplus
// workgroups, so the caller must compare with the count.
uint groupIndex() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
