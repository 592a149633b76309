% A PUMA 560 in the standard convention, lengths in metres; the zero pose is the L shape.
clear L
deg = pi/180;
L(1) = Revolute('d', 0, 'a', 0, 'alpha', pi/2, 'm', 0, 'qlim', [-160 160]*deg);
L(2) = Revolute('d', 0, 'a', 0.4318, 'alpha', 0, ...
    'r', [-0.3638, 0.006, 0.2275], 'qlim', [-45 225]*deg);
L(3) = Revolute('d', 0.15005, 'a', 0.0203, 'alpha', -pi/2, 'qlim', [-225 45]*deg);
L(4) = Revolute('d', 0.4318, 'a', 0, 'alpha', pi/2, 'qlim', [-110 170]*deg);
L(5) = Revolute('d', 0, 'a', 0, 'alpha', -pi/2, 'qlim', [-100 100]*deg);
L(6) = Revolute('d', 0, 'a', 0, 'alpha', 0, 'qlim', [-266 266]*deg);
p560 = SerialLink(L, 'name', 'Puma 560', 'comment', 'parameters; of 8/95');
qz = [0 0 0 0 0 0];  % zero angles
