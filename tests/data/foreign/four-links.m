% Everything that a listing may say: a slide, offsets, a vector, the modified convention, a base and a tool.
a1 = 0.3; d6 = 2*a1;
L1 = Link([0 0.1 a1 1.5708], 'modified');
L2 = Link([0 0 0.2 -pi/2 1 0.05], 'modified');   L3 = Link('theta', pi/4, 'a', 0.2, 'alpha', deg2rad(-90), 'modified');
L4 = Link([0.3 d6 0 0 0 -pi/2], 'modified');
L4.qlim = [-90 90]*pi/180;
bot = SerialLink([L1 L2 L3 L4], 'name', "four", 'tool', transl(0, 0, 0.1)*trotz(45, 'deg'));
bot.base = [1 0 0 0.1; 0 1 0 0; 0 0 1 0; 0 0 0 1]
