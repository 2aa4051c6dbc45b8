// Workgroups are laid out in rows (see dispatchSize): the last row may have surplus ones, so compare with the count.
uint groupIndex() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }
